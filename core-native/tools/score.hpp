#pragma once

#include <string>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/result.hpp"

namespace echoway::tools {

/// A track held against the truth. Errors are taken in the level's frame, so that a wrong room costs what it is off by.
struct Score {
  std::size_t rows = 0;
  std::size_t rows_nowhere = 0;  ///< Left out: they name no room yet.
  double mean_error_m = 0.0;
  double median_error_m = 0.0;
  double worst_error_m = 0.0;
  double mean_heading_error_rad = 0.0;
  double right_room_share = 0.0;
  double within_two_sigma_share = 0.0;
};

/// Where the logs came from: errors name the one at fault.
struct ScoredFiles {
  std::string track;
  std::string truth;
};

/// Truth between two of its rows is interpolated; track rows outside the truth's time are left out. Fails when a room
/// is unknown, a log is empty or the logs do not overlap.
Result<Score> score_track(const std::vector<TrackRow>& track, const std::vector<TruthRow>& truth,
                          const Building& building, const ScoredFiles& files);

}  // namespace echoway::tools
