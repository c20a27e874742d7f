#pragma once

#include "echoway/locate/estimate.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

/// Tells rooms that are entered, while that is news.
class RoomWatch {
 public:
  void clear() noexcept { *this = {}; }
  void update(const Estimate& estimate) noexcept;
  /// Another line has told the room.
  void was_told(RoomIndex room) noexcept;
  void tell(double now, Announcer& voice);

 private:
  RoomIndex room_ = kNoRoom;  ///< Told last, or to be told.
  bool pending_ = false;
  double since_ = 0.0;
};

}  // namespace echoway::guidance
