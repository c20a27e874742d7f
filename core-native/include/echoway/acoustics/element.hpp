#pragma once

#include <cstdint>

namespace echoway {

/// What sends an echo back (thesis sections 4.2 and 6.2.1).
enum class ElementKind : std::uint8_t {
  none,       ///< Nothing answers.
  wall,       ///< A plane, answering along its perpendicular.
  corner,     ///< A concave right angle, answering along the line to its apex.
  edge,       ///< A convex corner or a door jamb, diffracting.
  reflector,  ///< An all-reflective element, answering at any incidence.
};

}  // namespace echoway
