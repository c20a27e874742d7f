#include "score.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "report/following.hpp"

namespace echoway::tools {
namespace {

struct Placed {
  RoomIndex room = kNoRoom;
  Pose2 pose{};  // in the level's frame
};

std::optional<Placed> place(const TruthRow& row, const Building& building) {
  const RoomIndex room = building.find_room(row.room);
  if (room == kNoRoom) return std::nullopt;
  return Placed{room, building.room(room).frame.compose(row.pose)};
}

// The truth at `time_s`, between `before` and `after`; the room is that of the nearer row.
Placed interpolate(const TruthRow& before, const Placed& from, const TruthRow& after, const Placed& to, double time_s) {
  const double span = after.time_s - before.time_s;
  const double share = span > 0.0 ? std::clamp((time_s - before.time_s) / span, 0.0, 1.0) : 0.0;
  const double turn = wrap_angle(to.pose.heading - from.pose.heading);
  return {share < 0.5 ? from.room : to.room,
          {from.pose.position + share * (to.pose.position - from.pose.position),
           wrap_angle(from.pose.heading + share * turn)}};
}

Error unknown_room(const std::string& log, const std::string& file, const TruthRow& row) {
  return {log + " names room '" + row.room + "', which the building does not have", file, row.line};
}

/// By how much a row is off.
struct Miss {
  double position_m = 0.0;
  double heading_rad = 0.0;
  bool right_room = false;
  bool within_two_sigma = false;
};

Result<Miss> miss_of(const TrackRow& row, const TruthRow& before, const TruthRow& after, const Building& building,
                     const ScoredFiles& files) {
  const std::optional<Placed> from = place(before, building);
  const std::optional<Placed> to = place(after, building);
  const std::optional<Placed> estimate = place(row.where, building);
  if (!estimate) return unknown_room("the track", files.track, row.where);
  if (!from) return unknown_room("the truth", files.truth, before);
  if (!to) return unknown_room("the truth", files.truth, after);
  const Placed real = interpolate(before, *from, after, *to, row.where.time_s);
  const double error = distance(real.pose.position, estimate->pose.position);
  return Miss{error, std::abs(wrap_angle(real.pose.heading - estimate->pose.heading)), estimate->room == real.room,
              error <= 2.0 * row.sigma_m};
}

/// REQUIRES: some misses.
Score summed_up(const std::vector<Miss>& misses) {
  Score score;
  std::vector<double> errors;
  const double share = 1.0 / static_cast<double>(misses.size());
  for (const Miss& miss : misses) {
    errors.push_back(miss.position_m);
    score.mean_error_m += share * miss.position_m;
    score.mean_heading_error_rad += share * miss.heading_rad;
    score.right_room_share += miss.right_room ? share : 0.0;
    score.within_two_sigma_share += miss.within_two_sigma ? share : 0.0;
  }
  score.rows = misses.size();
  score.worst_error_m = *std::max_element(errors.begin(), errors.end());
  score.median_error_m = report::quantile(std::move(errors), 0.5);
  return score;
}

}  // namespace

Result<Score> score_track(const std::vector<TrackRow>& track, const std::vector<TruthRow>& truth,
                          const Building& building, const ScoredFiles& files) {
  if (truth.empty()) return Error{"the truth log has no rows", files.truth};
  if (track.empty()) return Error{"the track has no rows", files.track};
  std::vector<Miss> misses;
  std::size_t nowhere = 0;
  std::size_t next = 0;
  for (const TrackRow& row : track) {
    const double time = row.where.time_s;
    if (time < truth.front().time_s || time > truth.back().time_s) continue;
    if (row.where.room.empty()) {
      ++nowhere;
      continue;
    }
    while (next + 1 < truth.size() && truth[next + 1].time_s < time) ++next;
    const Result<Miss> miss = miss_of(row, truth[next], truth[std::min(next + 1, truth.size() - 1)], building, files);
    if (!miss) return miss.error();
    misses.push_back(*miss);
  }
  if (misses.empty()) {
    return Error{nowhere > 0 ? "the track names no room while there is truth" : "track and truth share no time",
                 files.track};
  }
  Score score = summed_up(misses);
  score.rows_nowhere = nowhere;
  return score;
}

}  // namespace echoway::tools
