#pragma once

#include <string>

#include "building/source.hpp"

namespace echoway {

/// `room hall`
[[nodiscard]] std::string room_label(const Building& building, RoomIndex room);
/// `the door between rooms 'hall' and '2'`
[[nodiscard]] std::string door_label(const Building& building, const Door& door);

/// Words for messages, in the unit in which the building's files are written.
class Phrases {
 public:
  explicit Phrases(LengthUnit unit) : unit_(unit) {}

  [[nodiscard]] std::string length(double metres) const;       ///< `0.7 ft`
  [[nodiscard]] std::string area(double square_metres) const;  ///< `12.5 square ft`
  [[nodiscard]] std::string point(Vec2 metres) const;          ///< `(4, 6.45)`, as the file has it.

 private:
  LengthUnit unit_;
};

}  // namespace echoway
