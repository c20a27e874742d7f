#include "tracker/summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracker/elementary.hpp"
#include "tracker/placed.hpp"

namespace echoway::tracker {
namespace {

struct Cluster {
  Placed anchor{};
  double weight = 0.0;
  Vec2 offset{};                 // Weighted sums, about the anchor.
  double xx = 0.0, xy = 0.0, yy = 0.0;
  double heading = 0.0, heading2 = 0.0;
  double speed = 0.0, scale = 0.0, scale2 = 0.0, bias = 0.0;
  double walking = 0.0, pace = 0.0;
  double turn_rate = 0.0, turning = 0.0;
  std::array<RoomIndex, 6> rooms{};
  std::array<double, 6> room_weight{};
  int room_count = 0;

  void add_room(RoomIndex room, double w) noexcept {
    for (int i = 0; i < room_count; ++i) {
      if (rooms[static_cast<std::size_t>(i)] == room) {
        room_weight[static_cast<std::size_t>(i)] += w;
        return;
      }
    }
    if (room_count == static_cast<int>(rooms.size())) return;
    rooms[static_cast<std::size_t>(room_count)] = room;
    room_weight[static_cast<std::size_t>(room_count++)] = w;
  }
};

// Where a particle lies from a cluster's anchor.
struct FromAnchor {
  Vec2 offset{};
  double turn = 0.0;
};

FromAnchor from_anchor(const Placed& at, const Placed& anchor) noexcept {
  return {at.position - anchor.position, wrap_near(at.heading - anchor.heading)};
}

void add(Cluster& c, const Particle& p, const FromAnchor& from, const RoomFrame& frame) noexcept {
  const double w = p.weight;
  const Vec2 d = from.offset;
  const double turn = from.turn;
  // The particle's own covariance, turned into the level's frame.
  const double xx = frame.cos2 * p.cov.xx - 2.0 * frame.cos_sin * p.cov.xy + frame.sin2 * p.cov.yy;
  const double yy = frame.sin2 * p.cov.xx + 2.0 * frame.cos_sin * p.cov.xy + frame.cos2 * p.cov.yy;
  const double xy = frame.cos_sin * (p.cov.xx - p.cov.yy) + (frame.cos2 - frame.sin2) * p.cov.xy;
  c.weight += w;
  c.offset = c.offset + w * d;
  c.xx += w * (xx + d.x * d.x);
  c.xy += w * (xy + d.x * d.y);
  c.yy += w * (yy + d.y * d.y);
  c.heading += w * turn;
  c.heading2 += w * turn * turn;
  c.speed += w * p.speed;
  c.scale += w * p.log_scale;
  c.scale2 += w * (p.cov.kk + p.log_scale * p.log_scale);
  c.bias += w * p.gyro_bias;
  c.turn_rate += w * p.turn_rate;
  c.turning += w * std::abs(p.turn_rate);
  if (p.gait == Gait::walking) {
    c.walking += w;
    c.pace += w * p.speed;
  }
  c.add_room(p.room, w);
}

double worst_sigma(double xx, double xy, double yy) noexcept {
  const double half = 0.5 * (xx + yy);
  const double spread = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  return std::sqrt(std::max(0.0, half + spread));
}

Hypothesis to_hypothesis(const Cluster& c, const Building& building, const SummaryParameters& parameters,
                         Estimate* full) noexcept {
  const double scale = c.weight > 0.0 ? 1.0 / c.weight : 0.0;
  const Vec2 mean = scale * c.offset;
  const double factor2 = parameters.sigma_factor * parameters.sigma_factor;
  const double floor2 = parameters.sigma_floor * parameters.sigma_floor;
  const double xx = factor2 * std::max(0.0, scale * c.xx - mean.x * mean.x) + floor2;
  const double yy = factor2 * std::max(0.0, scale * c.yy - mean.y * mean.y) + floor2;
  const double xy = factor2 * (scale * c.xy - mean.x * mean.y);
  int best = 0;
  for (int i = 1; i < c.room_count; ++i) {
    if (c.room_weight[static_cast<std::size_t>(i)] > c.room_weight[static_cast<std::size_t>(best)]) best = i;
  }
  Hypothesis h;
  h.room = c.rooms[static_cast<std::size_t>(best)];
  const Pose2 frame = building.room(h.room).frame;
  const double turn = scale * c.heading;
  h.pose.position = frame.inverse_transform(c.anchor.position + mean);
  h.pose.heading = wrap_angle(c.anchor.heading + turn - frame.heading);
  h.sigma_m = worst_sigma(xx, xy, yy);
  h.probability = c.weight;
  if (full != nullptr) {
    const double co = std::cos(frame.heading), si = std::sin(frame.heading);
    full->room = h.room;
    full->pose = h.pose;
    full->sigma_m = h.sigma_m;
    full->sigma_heading_rad = std::sqrt(std::max(0.0, scale * c.heading2 - turn * turn));
    full->room_probability = std::min(1.0, c.room_weight[static_cast<std::size_t>(best)]);
    full->covariance_xx = co * co * xx + 2.0 * co * si * xy + si * si * yy;
    full->covariance_yy = si * si * xx - 2.0 * co * si * xy + co * co * yy;
    full->covariance_xy = co * si * (yy - xx) + (co * co - si * si) * xy;
    full->speed_mps = scale * c.speed;
    full->sound_speed_scale = fast_exp(-scale * c.scale);
  }
  return h;
}

// A place less likely than this is no hypothesis; the means of one of denormal weight would not even be finite.
constexpr double kLeastProbability = 1e-12;

// Of a room that is known while the place in it is not (a featureless hall, a symmetric room) the heaviest cluster
// alone would be a confident lie: as long as it holds less than this share of the room's particles, all of them count.
constexpr double kOnePlace = 0.9;

// The room's own probability, and the spread of its particles about the reported position where no place stands out.
void describe_room(std::span<const Particle> particles, const SummaryParameters& parameters, Estimate& best) noexcept {
  double weight = 0.0, near = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Particle& p : particles) {
    if (p.room != best.room) continue;
    const Vec2 d = p.position - best.pose.position;
    weight += p.weight;
    if (squared_norm(d) < parameters.cluster_radius * parameters.cluster_radius) near += p.weight;
    xx += p.weight * (p.cov.xx + d.x * d.x);
    xy += p.weight * (p.cov.xy + d.x * d.y);
    yy += p.weight * (p.cov.yy + d.y * d.y);
  }
  if (!(weight > 0.0)) return;
  best.room_probability = std::min(1.0, weight);
  if (near >= kOnePlace * weight) return;
  const double factor = parameters.sigma_factor * parameters.sigma_factor / weight;
  const double floor2 = parameters.sigma_floor * parameters.sigma_floor;
  best.covariance_xx = factor * xx + floor2;
  best.covariance_xy = factor * xy;
  best.covariance_yy = factor * yy + floor2;
  best.sigma_m = worst_sigma(best.covariance_xx, best.covariance_xy, best.covariance_yy);
}

}  // namespace

Summary summarize(std::span<const Particle> particles, const Building& building,
                  const SummaryParameters& parameters) noexcept {
  Summary summary;
  std::array<Cluster, Summary::kMaxClusters> clusters;
  int count = 0;
  RoomFrame frame;
  const double radius2 = parameters.cluster_radius * parameters.cluster_radius;
  for (const Particle& p : particles) {
    if (p.room != frame.room) frame = RoomFrame(building, p.room);
    const Placed at = place(p, frame);
    FromAnchor from;
    int found = -1;
    for (int i = 0; i < count && found < 0; ++i) {
      const Placed& a = clusters[static_cast<std::size_t>(i)].anchor;
      if (a.level != at.level) continue;
      from = from_anchor(at, a);
      if (squared_norm(from.offset) < radius2 && std::abs(from.turn) < parameters.cluster_angle) found = i;
    }
    if (found < 0 && count < Summary::kMaxClusters) {
      found = count++;
      clusters[static_cast<std::size_t>(found)].anchor = at;
      from = {};
    }
    if (found >= 0) add(clusters[static_cast<std::size_t>(found)], p, from, frame);
  }
  // Insertion sort: a dozen at most, and std::stable_sort would allocate.
  for (int i = 1; i < count; ++i) {
    for (auto j = static_cast<std::size_t>(i); j > 0 && clusters[j].weight > clusters[j - 1].weight; --j) {
      std::swap(clusters[j], clusters[j - 1]);
    }
  }
  while (count > 1 && clusters[static_cast<std::size_t>(count - 1)].weight < kLeastProbability) --count;
  summary.count = count;
  for (int i = 0; i < count; ++i) {
    const Cluster& c = clusters[static_cast<std::size_t>(i)];
    summary.hypotheses[static_cast<std::size_t>(i)] =
        to_hypothesis(c, building, parameters, i == 0 ? &summary.best : nullptr);
  }
  if (count > 0) {
    describe_room(particles, parameters, summary.best);
    const Cluster& c = clusters[0];
    summary.log_scale = c.scale / c.weight;
    summary.log_scale_sigma = std::sqrt(std::max(0.0, c.scale2 / c.weight - summary.log_scale * summary.log_scale));
    summary.gyro_bias = c.bias / c.weight;
    summary.turn_rate = c.turn_rate / c.weight;
    summary.turning = c.turning / c.weight;
    summary.walking = c.walking / c.weight;
    summary.pace = c.walking > 0.0 ? c.pace / c.walking : 0.0;
  }
  return summary;
}

}  // namespace echoway::tracker
