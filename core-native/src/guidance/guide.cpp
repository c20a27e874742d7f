#include "echoway/guidance/guide.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "guidance/announcer.hpp"
#include "guidance/answers.hpp"
#include "guidance/breadcrumbs.hpp"
#include "guidance/certainty.hpp"
#include "guidance/climb_watch.hpp"
#include "guidance/doorstep.hpp"
#include "guidance/follower.hpp"
#include "guidance/health_watch.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/obstacle_watch.hpp"
#include "guidance/passer_by.hpp"
#include "guidance/place_change.hpp"
#include "guidance/room_watch.hpp"
#include "guidance/search.hpp"
#include "guidance/surroundings.hpp"
#include "guidance/turn_watch.hpp"

namespace echoway {

using guidance::Certainty;

struct Guide::Impl {
  Impl(const Router& r, const GuideConfig& c)
      : router(&r), config(c), voice(config), certainty(r, config, true), doorstep(r, config), heard(config.belt),
        follower(r, config, heard), obstacles(r, config), search(r, config, heard, turning), answers(r), passing(r),
        climbing(r, config) {}

  Status lead_to(const Goal& goal, RoutePreferences preferences, RoomIndex here);
  void start(bool facing_told);
  void update(const Estimate& newest, std::span<const Hypothesis> hypotheses);
  void answer_between_levels();
  void be_lost(std::span<const Hypothesis> places);
  [[nodiscard]] bool be_found();
  void lead();
  void tell_obstacle();
  [[nodiscard]] bool stands_where_obstacle_was_told() const;
  [[nodiscard]] bool position_usable() const { return guidance::is_place(router->building(), estimate); }
  [[nodiscard]] bool is_sure() const { return certainty.level() == Certainty::Level::sure; }
  [[nodiscard]] bool is_lost() const { return certainty.level() == Certainty::Level::lost; }

  const Router* router;
  GuideConfig config;
  guidance::Announcer voice;
  Certainty certainty;
  guidance::Doorstep doorstep;
  guidance::HeardSpace heard;
  guidance::Follower follower;
  guidance::ObstacleWatch obstacles;
  guidance::HealthWatch health;
  guidance::TurnWatch turning;
  guidance::Search search;
  guidance::Answers answers;
  guidance::PasserBy passing;
  guidance::ClimbWatch climbing;
  guidance::RoomWatch rooms;
  guidance::Breadcrumbs crumbs;
  Estimate estimate{};
  double obstacle_told = -1e300;
  Estimate told_at{};        ///< Where the wearer was then.
  double obstacle_m = -1.0;  ///< Of what is in the way now.
  bool belt_lost = false;
  bool doubts_level = false;  ///< The wearer cannot be where they are thought to be.
};

Guide::Guide(const Router& router, const GuideConfig& config) : impl_(std::make_unique<Impl>(router, config)) {}
Guide::Guide(Guide&&) noexcept = default;
Guide& Guide::operator=(Guide&&) noexcept = default;
Guide::~Guide() = default;

const GuideConfig& Guide::config() const noexcept { return impl_->config; }

Status Guide::Impl::lead_to(const Goal& goal, RoutePreferences preferences, RoomIndex here) {
  Result<RouteTree> tree = router->tree_to(goal, preferences);
  if (!tree) return tree.error();
  if (Status reachable = router->check_goal(*tree, here); !reachable) return reachable;
  follower.lead_to(std::move(*tree));
  answers.ask_destination();
  return success();
}

Status Guide::set_destination(const Goal& goal, RoutePreferences preferences, RoomIndex here) {
  return impl_->lead_to(goal, preferences, here);
}

Status Guide::set_destination(std::string_view name, RoutePreferences preferences, RoomIndex here) {
  const Result<Goal> goal = impl_->router->find_goal(name);
  if (!goal) return goal.error();
  return impl_->lead_to(*goal, preferences, here);
}

Status Guide::way_out(RoutePreferences preferences, RoomIndex here) {
  return impl_->lead_to({Goal::Kind::nearest_exit, -1, {}}, preferences, here);
}

Status Guide::back_track() {
  if (impl_->crumbs.all().empty()) return Error{"there is no way back yet: nothing has been walked"};
  impl_->follower.lead_back(impl_->crumbs.all());
  impl_->answers.ask_destination();
  return success();
}

void Guide::clear_destination() { impl_->follower.stop(); }
void Guide::where_am_i() { impl_->answers.ask_where(); }
bool Guide::repeat() { return impl_->voice.ask_again(); }

bool Guide::next_cue(Cue& cue) { return impl_->voice.pop(cue); }
std::optional<LevelTransition> Guide::take_level_transition() { return impl_->follower.take_transition(); }
bool Guide::take_doubt() {
  const bool gets_nowhere = impl_->follower.take_doubt() && !impl_->certainty.was_told();
  return std::exchange(impl_->doubts_level, false) || gets_nowhere;
}
bool Guide::has_destination() const { return impl_->follower.active(); }
Status Guide::check_way(RoomIndex room, std::optional<Vec2> at) const { return impl_->follower.check_way(room, at); }
double Guide::obstacle_ahead_m() const { return impl_->obstacle_m; }
const Route& Guide::route() const { return impl_->follower.route(); }
std::span<const Spot> Guide::breadcrumbs() const { return impl_->crumbs.all(); }

void Guide::on_firing(const Firing& firing) {
  impl_->heard.on_firing(firing);
  if (impl_->is_lost() || !impl_->position_usable()) return;
  impl_->obstacles.on_firing(firing, impl_->estimate);
}

void Guide::on_belt_health(const BeltHealth& health, double now_s) {
  if (!std::isfinite(now_s)) return;
  impl_->belt_lost = health.link == BeltLink::lost;
  impl_->health.update(health, now_s, impl_->voice);
}

void Guide::on_start(const Start& start) { impl_->start(start.heading.has_value()); }

void Guide::on_estimate(const Estimate& estimate, std::span<const Hypothesis> hypotheses) {
  if (std::isfinite(estimate.time_s)) impl_->update(estimate, hypotheses);
}

void Guide::Impl::start(bool facing_told) {
  certainty = Certainty(*router, config, facing_told);
  doorstep.clear();
  obstacles.clear();
  heard.clear();
  follower.start_over();
  voice.forget_instruction();
  search.begin();
  answers.start_over(follower.active());
  passing.clear();
  climbing.clear();
  rooms.clear();
  crumbs.clear();
  estimate = told_at = {};
  obstacle_told = -1e300;
  obstacle_m = -1.0;
}

void Guide::Impl::update(const Estimate& newest, std::span<const Hypothesis> hypotheses) {
  const double now = newest.time_s;
  estimate = doorstep.settle(newest);
  obstacle_m = -1.0;
  if (voice.is_asked() && follower.is_between_levels()) answer_between_levels();
  if (!voice.is_way_asked() || !follower.active()) voice.answer(now);
  Estimate judged = estimate;
  judged.room_probability = guidance::place_probability(*router, config, newest, hypotheses);
  if (!position_usable()) judged.state = TrackState::lost;
  certainty.update(judged, now < std::max(follower.suspended_until(), climbing.until()));
  if (is_finite(newest.pose)) turning.update(newest.pose.heading, now);
  if (belt_lost) return;  // said already; nothing that is known now stays known
  if (is_lost()) {
    be_lost(hypotheses);
    return;
  }
  // Nobody is told to stop and turn on stairs, nor led by a position that does not fit.
  if (!position_usable() || (now < climbing.until() && !certainty.fits_now())) return;
  if (is_sure()) climbing.update(estimate);
  if (search.is_on() && !be_found()) tell_obstacle();
  else lead();
}

void Guide::Impl::lead() {
  const double now = estimate.time_s;
  if (is_sure()) crumbs.drop({estimate.room, estimate.pose.position});
  rooms.update(estimate);
  tell_obstacle();
  const guidance::Follower::Trust trust{certainty.level() == Certainty::Level::vague, certainty.is_unproven()};
  if (voice.is_way_asked() && voice.is_free(now)) {
    voice.take_way_question();
    follower.tell_again();
  }
  if (!certainty.jumped(now)) follower.update(estimate, trust, turning.turning() || search.sets_off(now), voice);
  const bool answering = answers.is_answering() || answers.is_where_asked();
  answers.tell(estimate, follower.active() ? &follower.route() : nullptr, voice);
  if (!answering) rooms.tell(now, voice);
  if (!follower.active() && is_sure()) passing.tell(estimate, voice);
}

/// Who asks on the way to another level stands somewhere, and nobody asks in mid-flight.
void Guide::Impl::answer_between_levels() {
  using Asked = guidance::LevelChange::Asked;
  const Asked asked = follower.ask_between_levels(estimate);
  if (asked == Asked::again) return;
  voice.take_way_question();
  voice.forget_instruction();
  climbing.clear();
  certainty.reject(estimate.time_s);
  doubts_level = asked == Asked::never;
}

void Guide::Impl::be_lost(std::span<const Hypothesis> places) {
  obstacles.clear();
  if (voice.is_way_asked()) {  // which is that nobody knows
    voice.take_way_question();
    answers.ask_where();
  }
  const bool guesses = search.is_due(estimate.time_s) && position_usable();
  const auto wanted = guesses ? follower.direction_from(estimate) : std::nullopt;
  const bool answered =
      search.update(estimate, places, wanted, !certainty.was_sure(), answers.is_where_asked(), voice);
  if (answered) answers.where_was_answered();
}

/// True once the wearer knows. Who was told so a moment ago and has been lost again waits: a place that comes and goes
/// is none to be led from.
bool Guide::Impl::be_found() {
  if (!search.was_told()) {
    search.end();
    return true;  // it was never said that the place is not known: the room is named like one that is entered
  }
  const double now = estimate.time_s;
  const bool asked = answers.is_where_asked() || voice.is_way_asked();
  const Cue plain = guidance::room_cue(CueKind::found, estimate.room);
  if (!voice.would_speak(plain, now, asked)) return false;
  Cue cue = plain;
  if (follower.active()) {
    if (!turning.turning() && !search.sets_off(now)) cue.tail = follower.next_step(estimate, plain, voice, asked);
  } else {
    const Cue door = guidance::nearest_door(*router, estimate);
    if (door.distance_m >= 0.0) cue.tail = {CueKind::door, true, door.direction, -1.0};
  }
  voice.forget_search();
  (void)voice.offer(cue, now, asked);
  search.end();
  rooms.was_told(estimate.room);
  return true;
}

/// Nothing has changed then: who stands before a thing knows of it.
bool Guide::Impl::stands_where_obstacle_was_told() const {
  constexpr double kMoved = 0.4;  // metres
  constexpr double kTurned = degrees(25.0);
  return estimate.room == told_at.room && distance(estimate.pose.position, told_at.pose.position) < kMoved &&
         std::abs(wrap_angle(estimate.pose.heading - told_at.pose.heading)) < kTurned;
}

void Guide::Impl::tell_obstacle() {
  const double now = estimate.time_s;
  if (!is_sure()) return;
  obstacles.steady(estimate, [&](Vec2 at) { follower.note_obstacle(estimate, at); });
  const double reach = config.obstacle_m + std::max(0.0, estimate.speed_mps) * (config.reaction_s + 1.2);
  const auto thing = obstacles.nearest(estimate, reach);
  if (!thing.present) return;
  obstacle_m = thing.distance_m;
  if (now - obstacle_told < config.repeat_gap_s || stands_where_obstacle_was_told()) return;
  Cue cue = make_cue(CueKind::obstacle);
  cue.direction = thing.direction;
  cue.has_direction = true;
  cue.distance_m = thing.distance_m;
  if (!voice.offer(cue, now)) return;
  obstacle_told = now;
  told_at = estimate;
  follower.note_feeling(cue, estimate);
}

}  // namespace echoway
