#include <cmath>

#include "echoway/io/logs.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

bool sound(const TruthRow& row) { return std::isfinite(row.time_s) && is_finite(row.pose); }

}  // namespace

/// The same bytes as a truth log and as a track.
std::string track_log(Bytes data) {
  const MemoryFile file(data);
  if (const Result<std::vector<TruthRow>> truth = read_truth_log(file.path())) {
    for (const TruthRow& row : *truth) {
      if (!sound(row) || row.room.empty()) return "a row of the truth log is unusable";
    }
  }
  const Result<std::vector<TrackRow>> track = read_track_log(file.path());
  if (!track) return track.error().message.empty() ? "an error without words" : "";
  for (const TrackRow& row : *track) {
    if (!sound(row.where) || !(row.sigma_m >= 0.0) || !std::isfinite(row.sigma_m) ||
        !(row.room_probability >= 0.0 && row.room_probability <= 1.0)) {
      return "a row of the track is unusable";
    }
  }
  return "";
}

}  // namespace echoway::fuzz
