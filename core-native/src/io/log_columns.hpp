#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "echoway/locate/estimate.hpp"
#include "echoway/motion/motion_hint.hpp"

namespace echoway {

inline constexpr std::array<std::string_view, 3> kScanColumns{"time_s", "sensor", "range_m"};
inline constexpr std::array<std::string_view, 3> kMotionColumns{"time_s", "kind", "value"};
inline constexpr std::array<std::string_view, 5> kTruthColumns{"time_s", "room", "x_m", "y_m", "heading_deg"};
inline constexpr std::array<std::string_view, 8> kTrackColumns{
    "time_s", "room", "x_m", "y_m", "heading_deg", "sigma_m", "room_probability", "state"};

[[nodiscard]] std::string_view to_word(MotionKind kind) noexcept;
[[nodiscard]] std::optional<MotionKind> motion_kind_from(std::string_view word) noexcept;
[[nodiscard]] std::optional<TrackState> track_state_from(std::string_view word) noexcept;
/// Whether `word` is no state but begins one.
[[nodiscard]] bool is_cut_track_state(std::string_view word) noexcept;

}  // namespace echoway
