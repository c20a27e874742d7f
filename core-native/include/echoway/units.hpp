#pragma once

#include <cmath>
#include <numbers>

namespace echoway {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr double kMetresPerFoot = 0.3048;

[[nodiscard]] constexpr double feet(double ft) noexcept { return ft * kMetresPerFoot; }
[[nodiscard]] constexpr double degrees(double deg) noexcept { return deg * (kPi / 180.0); }
[[nodiscard]] constexpr double to_degrees(double rad) noexcept { return rad * (180.0 / kPi); }

/// Speed of sound in dry air, metres a second, from `celsius`: ideal-gas law, 331.3 sqrt(1 + T/273.15).
/// About 0.17 % per kelvin near room temperature.
[[nodiscard]] inline double speed_of_sound(double celsius) noexcept {
  return 331.3 * std::sqrt(1.0 + celsius / 273.15);
}

/// The air temperature at which ranges are taken to be right when nobody says otherwise: 20 degrees Celsius, 343.2 m/s.
inline constexpr double kReferenceCelsius = 20.0;

}  // namespace echoway
