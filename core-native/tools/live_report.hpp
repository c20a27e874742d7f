#pragma once

#include "echoway/session.hpp"

namespace echoway::tools {

/// Prints, line by line, what a live wearer would want to know: where they are once a second, and every change of the
/// belt's link and of the state at once.
class LiveReport {
 public:
  void update(const Session& session);

 private:
  void print_link(BeltLink link);
  void print_position(const Session& session);

  BeltLink link_ = BeltLink::absent;
  RoomIndex room_ = kNoRoom;
  TrackState state_ = TrackState::searching;
  double printed_at_ = -1e300;
};

}  // namespace echoway::tools
