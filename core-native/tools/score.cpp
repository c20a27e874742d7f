#include "score.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

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

Error unknown_room(const std::string& log, const std::string& room) {
  return {log + " names room '" + room + "', which the building does not have"};
}

}  // namespace

Result<Score> score_track(const std::vector<TrackRow>& track, const std::vector<TruthRow>& truth,
                          const Building& building) {
  if (truth.empty()) return Error{"the truth log has no rows"};
  Score score;
  std::vector<double> errors;
  double heading_sum = 0.0;
  std::size_t right = 0;
  std::size_t covered = 0;
  std::size_t next = 0;
  for (const TrackRow& row : track) {
    const double time = row.where.time_s;
    if (time < truth.front().time_s || time > truth.back().time_s) continue;
    if (row.where.room.empty()) {
      ++score.rows_nowhere;
      continue;
    }
    while (next + 1 < truth.size() && truth[next + 1].time_s < time) ++next;
    const TruthRow& before = truth[next];
    const TruthRow& after = truth[std::min(next + 1, truth.size() - 1)];
    const std::optional<Placed> from = place(before, building);
    const std::optional<Placed> to = place(after, building);
    const std::optional<Placed> estimate = place(row.where, building);
    if (!estimate) return unknown_room("the track", row.where.room);
    if (!from) return unknown_room("the truth", before.room);
    if (!to) return unknown_room("the truth", after.room);
    const Placed real = interpolate(before, *from, after, *to, time);
    const double error = distance(real.pose.position, estimate->pose.position);
    errors.push_back(error);
    heading_sum += std::abs(wrap_angle(real.pose.heading - estimate->pose.heading));
    right += estimate->room == real.room ? 1 : 0;
    covered += error <= 2.0 * row.sigma_m ? 1 : 0;
  }
  if (errors.empty()) {
    return Error{score.rows_nowhere > 0 ? "the track names no room while there is truth" : "track and truth share no time"};
  }
  const auto n = static_cast<double>(errors.size());
  score.rows = errors.size();
  score.mean_error_m = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
  score.worst_error_m = *std::max_element(errors.begin(), errors.end());
  score.median_error_m = report::quantile(std::move(errors), 0.5);
  score.mean_heading_error_rad = heading_sum / n;
  score.right_room_share = static_cast<double>(right) / n;
  score.within_two_sigma_share = static_cast<double>(covered) / n;
  return score;
}

}  // namespace echoway::tools
