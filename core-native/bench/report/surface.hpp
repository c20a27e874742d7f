#pragma once

#include <vector>

#include "rooms.hpp"

namespace echoway::report {

/// The objective over a room's floor at one heading (figure 6.6).
struct Surface {
  struct Point {
    Vec2 at{};
    double objective_m = 0.0;
  };
  std::vector<Point> points;  ///< Only where the thesis would compare at all.

  [[nodiscard]] const Point& lowest() const;
  /// Other minima, farther than 2 ft from the lowest and from each other, that rise above it by less than a quarter of
  /// what the median point does.
  [[nodiscard]] int rivals() const;
  /// What of it lies within `radius` of `centre`.
  [[nodiscard]] Surface within(Vec2 centre, double radius) const;
};

[[nodiscard]] Surface error_surface(RoomMatcher& matcher, const thesis::Scan& scan, double heading, const Room& room,
                                    double spacing_m);

}  // namespace echoway::report
