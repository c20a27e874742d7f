#include "guidance/met_frame.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "echoway/units.hpp"

namespace echoway::guidance {
namespace {

constexpr double kPlay = 0.2;       ///< Metres.
constexpr double kFarBeyond = 0.7;  ///< What is heard so far beyond a door's wall is in the next room, metres.
constexpr double kLasts = 90.0;     ///< What was met says where the wearer is for so long, s.

/// Whether who goes from `from` to `ahead` can have met the frame that they were about to pass.
bool may_meet(const Doorway& doorway, Vec2 from, Vec2 ahead) noexcept {
  constexpr double kBefore = 0.75;  // metres from the door's wall
  constexpr double kBeside = 1.0;   // and from its axis
  constexpr double kSteep = 0.5;    // cosine
  const double near = doorway.before(from);
  const bool about_there = near > 0.0 && near < kBefore && std::abs(doorway.beside(from)) < kBeside;
  return about_there && dot(ahead, doorway.through()) > kSteep &&
         std::abs(doorway.crossing(from, ahead)) < 0.5 * doorway.width() + kPlay;
}

}  // namespace

/// A place is as well known as the tracker says, or now and then is not.
void MetFrame::begin(const Doorway& doorway, std::int32_t door, const Estimate& e) noexcept {
  constexpr double kSurest = 0.1;  // metres
  constexpr double kWide = 0.45;
  constexpr double kWrong = 0.1;   // share
  const double usual = std::clamp(e.sigma_m, kSurest, kWide);
  door_ = door;
  room_ = e.room;
  centre_ = doorway.centre();
  along_ = doorway.along();
  aside_ = 0.0;
  const auto bell = [](double x, double sigma) { return std::exp(-0.5 * x * x / (sigma * sigma)) / sigma; };
  for (std::size_t i = 0; i < kOffsets; ++i) {
    weight_[i] = (1.0 - kWrong) * bell(offset(i), usual) + kWrong * bell(offset(i), kWide);
  }
}

void MetFrame::weigh(const Doorway& doorway, const Pose2& taken, double now) noexcept {
  constexpr double kBody = 0.22;      // metres from the wearer's middle to what they meet
  constexpr double kOther = 0.06;     // something else may have been met,
  constexpr double kUnheard = 0.3;    // or have answered
  const double half = 0.5 * doorway.width();
  const Vec2 ahead = unit_from_angle(taken.heading);
  const double slope = dot(ahead, doorway.through());
  const bool wall = hears_wall(doorway, taken, now);
  const bool through = hears_beyond(doorway, taken, now);
  double sum = 0.0;
  for (std::size_t i = 0; i < kOffsets; ++i) {
    const Vec2 from = taken.position + offset(i) * along_;
    const double gap = (half - std::abs(doorway.crossing(from, ahead))) * slope;
    if (gap > kBody) weight_[i] *= kOther;
    const bool before_opening = std::abs(doorway.beside(from)) < half;
    if ((wall && before_opening) || (through && !before_opening)) weight_[i] *= kUnheard;
    sum += weight_[i];
  }
  for (double& w : weight_) w /= sum;
}

/// The mean on the side where more of the weight lies: between the two the opening would be right ahead.
void MetFrame::settle() noexcept {
  std::array<double, 2> sum{};
  std::array<double, 2> moment{};
  for (std::size_t i = 0; i < kOffsets; ++i) {
    const std::size_t side = offset(i) > 0.0 ? 1 : 0;
    sum[side] += weight_[i];
    moment[side] += weight_[i] * offset(i);
  }
  const std::size_t likelier = sum[1] > sum[0] ? 1 : 0;
  aside_ = moment[likelier] / sum[likelier];
}

std::optional<Doorway> MetFrame::next_doorway(RoomIndex room, const Way& way) const noexcept {
  const LinePoint* door = way.first_door().door;
  return door == nullptr ? std::nullopt : Doorway::of(*router_, room, door->index, config_->body_m);
}

bool MetFrame::is_known(const Estimate& e, std::int32_t door) const noexcept {
  return door_ == door && room_ == e.room && e.time_s - met_s_ < kLasts;
}

Pose2 MetFrame::taken_pose(const Estimate& e, std::int32_t door) const noexcept {
  return {is_known(e, door) ? e.pose.position - aside_ * along_ : e.pose.position, e.pose.heading};
}

bool MetFrame::meet(const View& view, const Way& way) {
  const Estimate& e = *view.estimate;
  const auto doorway = next_doorway(e.room, way);
  if (!doorway || !may_meet(*doorway, e.pose.position, unit_from_angle(e.pose.heading))) return false;
  const std::int32_t door = way.first_door().door->index;
  if (!is_known(e, door)) begin(*doorway, door, e);
  weigh(*doorway, taken_pose(e, door), view.now);
  settle();
  met_s_ = view.now;
  return true;
}

bool MetFrame::hear(const View& view, const Way& way) {
  const Estimate& e = *view.estimate;
  constexpr double kJamb = 0.15;  // metres: so far inside the opening only the opening lies before the wearer
  const auto doorway = next_doorway(e.room, way);
  if (!doorway) return false;
  const Vec2 taken = taken_pose(e, way.first_door().door->index).position;
  const bool before_opening = std::abs(doorway->beside(taken)) < 0.5 * doorway->width() - kJamb;
  return before_opening && hears_wall(*doorway, e.pose, view.now) && meet(view, way);
}

/// Whether there is a wall right before the wearer where the plan has the opening.
bool MetFrame::hears_wall(const Doorway& doorway, const Pose2& pose, double now) const noexcept {
  const auto echo = heard_->toward(wrap_angle(doorway.axis() - pose.heading), now);
  return echo && *echo < doorway.before(pose.position) + kPlay;
}

/// Whether what answers right before the wearer, where the plan has the opening, is in the room behind it.
bool MetFrame::hears_beyond(const Doorway& doorway, const Pose2& pose, double now) const noexcept {
  const auto echo = heard_->toward(wrap_angle(doorway.axis() - pose.heading), now);
  return echo && *echo > doorway.before(pose.position) + kFarBeyond;
}

bool MetFrame::hears_through(const View& view, const Way& way, double direction) const noexcept {
  constexpr double kNearest = 0.4;              // metres from the door's wall: who stands nearer may not hear it
  constexpr double kFarthest = 1.3;             // nor does it fill a sensor's beam from farther away
  constexpr double kAslant = degrees(30.0);
  const Pose2& pose = view.estimate->pose;
  const auto doorway = next_doorway(view.estimate->room, way);
  if (!doorway) return false;
  const double near = doorway->before(pose.position);
  const double through = wrap_angle(doorway->axis() - pose.heading);
  if (near < kNearest || near > kFarthest || std::abs(wrap_angle(through - direction)) > kAslant) return false;
  return hears_beyond(*doorway, pose, view.now);
}

void MetFrame::watch(const Estimate& e, bool walking) noexcept {
  constexpr double kComesToAStand = 1.5;  // s
  constexpr double kMoves = 0.2;          // metres
  if (walking) walked_s_ = e.time_s;
  if (e.time_s - walked_s_ < kComesToAStand) stood_ = e.pose.position;
  else if (e.room == room_ && std::abs(dot(e.pose.position - stood_, along_)) > kMoves) forget();
}

Estimate MetFrame::place(const Estimate& e) const noexcept {
  constexpr double kNear = 2.0;  // metres
  const bool holds = door_ >= 0 && e.room == room_ && e.time_s - met_s_ < kLasts &&
                     distance(e.pose.position, centre_) < kNear;
  if (!holds) return e;
  Estimate there = e;
  there.pose.position = e.pose.position + aside_ * along_;
  return there;
}

}  // namespace echoway::guidance
