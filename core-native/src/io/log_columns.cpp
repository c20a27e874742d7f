#include "io/log_columns.hpp"

#include <algorithm>

#include "echoway/io/logs.hpp"

namespace echoway {
namespace {

constexpr std::array kMotionKinds{MotionKind::step, MotionKind::yaw_rate, MotionKind::heading};
constexpr std::array kTrackStates{TrackState::searching, TrackState::tracking, TrackState::lost};

}  // namespace

std::string_view to_word(MotionKind kind) noexcept {
  switch (kind) {
    case MotionKind::yaw_rate:
      return "yaw_rate_dps";
    case MotionKind::heading:
      return "heading_deg";
    case MotionKind::step:
      break;
  }
  return "step";
}

std::optional<MotionKind> motion_kind_from(std::string_view word) noexcept {
  for (const MotionKind kind : kMotionKinds) {
    if (word == to_word(kind)) return kind;
  }
  return std::nullopt;
}

const char* to_string(TrackState state) noexcept {
  switch (state) {
    case TrackState::tracking:
      return "tracking";
    case TrackState::lost:
      return "lost";
    case TrackState::searching:
      break;
  }
  return "searching";
}

bool is_cut_track_state(std::string_view word) noexcept {
  return std::any_of(kTrackStates.begin(), kTrackStates.end(), [&](TrackState state) {
    const std::string_view whole = to_string(state);
    return word != whole && whole.starts_with(word);
  });
}

std::optional<TrackState> track_state_from(std::string_view word) noexcept {
  for (const TrackState state : kTrackStates) {
    if (word == to_string(state)) return state;
  }
  return std::nullopt;
}

}  // namespace echoway
