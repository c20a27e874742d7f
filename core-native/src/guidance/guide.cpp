#include "echoway/guidance/guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "guidance/announcer.hpp"
#include "guidance/certainty.hpp"
#include "guidance/follower.hpp"
#include "guidance/health_watch.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/obstacle_watch.hpp"
#include "guidance/place_change.hpp"
#include "guidance/probe.hpp"
#include "guidance/surroundings.hpp"
#include "guidance/turn_watch.hpp"

namespace echoway {

using guidance::Certainty;

namespace {

constexpr double kCrumbSpacing = 1.5;      ///< Metres.
constexpr std::size_t kCrumbs = 1024;
constexpr double kPendingFor = 3.0;        ///< Seconds that a room entered is worth telling.
constexpr double kAskedFor = 12.0;         ///< The same for an answer.
constexpr double kFreePlace = 2.0;         ///< Places are told from here without a way, metres.
constexpr double kPassing = 1.8;           ///< Doors, exits, stairs and elevators, from here.

}  // namespace

struct Guide::Impl {
  Impl(const Router& r, const GuideConfig& c)
      : router(&r), config(c), voice(config), certainty(r, config), follower(r, config), obstacles(r, config), heard(config.belt) {
    crumbs.reserve(kCrumbs);
    told_places.resize(r.building().places.size(), false);
  }

  Status lead_to(const Goal& goal, RoutePreferences preferences);
  void answer_destination();
  void handle_lost(std::span<const Hypothesis> places);
  [[nodiscard]] bool stop_before_echo();
  [[nodiscard]] Cue probe_cue(std::span<const Hypothesis> places);
  void handle_found();
  void tell_obstacle();
  void note_room();
  void tell_pending();
  void tell_in_passing();
  void tell_free_place();
  void drop_crumb();
  void note_link();
  [[nodiscard]] bool position_usable() const { return guidance::is_place(router->building(), estimate); }

  const Router* router;
  GuideConfig config;
  guidance::Announcer voice;
  Certainty certainty;
  guidance::Follower follower;
  guidance::ObstacleWatch obstacles;
  guidance::HealthWatch health;
  guidance::HeardSpace heard;
  guidance::TurnWatch turning;
  Estimate estimate{};
  std::vector<Spot> crumbs;
  bool was_lost = true;
  bool told_lost = false;
  double lost_since = -1.0;
  double last_probe = -1e300;
  bool probed_by_turn = false;       ///< The last request was to turn.
  double step_direction = 0.0;       ///< Of the last step that was asked for, from where the chest faced at first.
  RoomIndex room = kNoRoom;          ///< Told last.
  bool room_pending = false;
  double room_since = 0.0;
  double obstacle_told = -1e300;
  double obstacle_m = -1.0;          ///< Of what is in the way now.
  CueLandmark told_in_passing{};     ///< The last thing that was told without a way.
  std::vector<bool> told_places;     ///< By place: told, and not left since.
  // Answers wait here for the voice, first to last.
  std::array<Cue, 3> asked{};
  std::size_t asked_count = 0;
  std::size_t asked_next = 0;
  double asked_at = 0.0;
  bool where_asked = false;
  bool destination_asked = false;
  bool belt_lost = false;
  double maybe_climbing_until = -1e300;  ///< The wearer was last known at stairs or an elevator.
};

Guide::Guide(const Router& router, const GuideConfig& config) : impl_(std::make_unique<Impl>(router, config)) {}
Guide::Guide(Guide&&) noexcept = default;
Guide& Guide::operator=(Guide&&) noexcept = default;
Guide::~Guide() = default;

Status Guide::Impl::lead_to(const Goal& goal, RoutePreferences preferences) {
  Result<RouteTree> tree = router->tree_to(goal, preferences);
  if (!tree) return tree.error();
  follower.lead_to(std::move(*tree));
  destination_asked = true;
  return success();
}

Status Guide::set_destination(const Goal& goal, RoutePreferences preferences) { return impl_->lead_to(goal, preferences); }

Status Guide::set_destination(std::string_view name, RoutePreferences preferences) {
  const Result<Goal> goal = impl_->router->find_goal(name);
  if (!goal) return goal.error();
  return impl_->lead_to(*goal, preferences);
}

Status Guide::way_out(RoutePreferences preferences) {
  return impl_->lead_to({Goal::Kind::nearest_exit, -1, {}}, preferences);
}

Status Guide::back_track() {
  if (impl_->crumbs.empty()) return Error{"there is no way back yet: nothing has been walked"};
  impl_->follower.lead_back(impl_->crumbs);
  impl_->destination_asked = true;
  return success();
}

void Guide::clear_destination() { impl_->follower.stop(); }
void Guide::where_am_i() { impl_->where_asked = true; }
bool Guide::repeat() { return impl_->voice.ask_again(); }

bool Guide::next_cue(Cue& cue) { return impl_->voice.pop(cue); }
std::optional<LevelTransition> Guide::take_level_transition() { return impl_->follower.take_transition(); }
bool Guide::has_destination() const { return impl_->follower.active(); }
double Guide::obstacle_ahead_m() const { return impl_->obstacle_m; }
const Route& Guide::route() const { return impl_->follower.route(); }
std::span<const Spot> Guide::breadcrumbs() const { return impl_->crumbs; }

void Guide::on_firing(const Firing& firing) {
  impl_->heard.on_firing(firing);
  if (impl_->certainty.level() == Certainty::Level::lost || !impl_->position_usable()) return;
  impl_->obstacles.on_firing(firing, impl_->estimate);
}

void Guide::on_belt_health(const BeltHealth& health, double now_s) {
  if (!std::isfinite(now_s)) return;
  impl_->belt_lost = health.link == BeltLink::lost;
  impl_->health.update(health, now_s, impl_->voice);
}

void Guide::on_restart() {
  Impl& g = *impl_;
  g.certainty = Certainty(*g.router, g.config);
  g.obstacles.clear();
  g.heard.clear();
  g.follower.start_over();
  g.voice.forget_instruction();
  g.estimate = {};
  g.crumbs.clear();
  g.was_lost = true;
  g.told_lost = false;
  g.lost_since = -1.0;
  g.last_probe = g.obstacle_told = g.maybe_climbing_until = -1e300;
  g.room = kNoRoom;
  g.room_pending = false;
  g.obstacle_m = -1.0;
  g.told_in_passing = {};
  g.told_places.assign(g.told_places.size(), false);
  g.where_asked = g.where_asked || g.asked_next < g.asked_count;  // an answer that is half given is given afresh
  g.asked_count = g.asked_next = 0;
  g.destination_asked = g.follower.active();
}

void Guide::on_estimate(const Estimate& estimate, std::span<const Hypothesis> hypotheses) {
  Impl& g = *impl_;
  if (!std::isfinite(estimate.time_s)) return;
  g.estimate = estimate;
  g.obstacle_m = -1.0;
  g.voice.answer(estimate.time_s);
  Estimate judged = estimate;
  if (!g.position_usable()) judged.state = TrackState::lost;
  const double now = judged.time_s;
  g.certainty.update(judged, now < std::max(g.follower.suspended_until(), g.maybe_climbing_until));
  if (is_finite(estimate.pose)) g.turning.update(estimate.pose.heading, now);
  if (g.belt_lost) return;  // said already; nothing that is known now stays known
  if (g.certainty.level() == Certainty::Level::lost) {
    g.handle_lost(hypotheses);
    return;
  }
  if (!g.position_usable()) return;
  // Nobody is told to stop and turn on stairs, nor led by a position that does not fit.
  if (now < g.maybe_climbing_until && !g.certainty.fits_now()) return;
  g.note_link();
  if (g.was_lost) g.handle_found();
  g.drop_crumb();
  g.note_room();
  g.tell_obstacle();
  const bool vague = g.certainty.level() == Certainty::Level::vague;
  if (!g.certainty.jumped(now)) g.follower.update(g.estimate, vague, g.turning.turning(), g.voice);
  g.tell_pending();
  if (g.follower.active()) return;
  g.tell_in_passing();
  g.tell_free_place();
}

void Guide::Impl::handle_lost(std::span<const Hypothesis> places) {
  const double now = estimate.time_s;
  if (!was_lost || lost_since < 0.0) lost_since = now;
  was_lost = true;
  obstacles.clear();
  // At the start the tracker is given a moment to find the wearer before anything is said.
  constexpr double kStartPatience = 3.0;
  if (!certainty.was_sure() && now - lost_since < kStartPatience && !where_asked) return;
  if (!told_lost || where_asked) {
    if (voice.offer(make_cue(CueKind::uncertain), now, where_asked)) {
      told_lost = true;
      where_asked = false;
      last_probe = now;
      probed_by_turn = true;
    }
    return;
  }
  if (stop_before_echo() || now - last_probe < (probed_by_turn ? config.probe_gap_s : config.step_gap_s)) return;
  const Cue cue = probe_cue(places);
  if (!voice.offer(cue, now)) return;
  last_probe = now;
  probed_by_turn = cue.kind == CueKind::probe_turn;
  if (!probed_by_turn) step_direction = wrap_angle(cue.direction + turning.turned());
}

/// Who is lost and walks on all the same is kept from what the belt hears before them.
bool Guide::Impl::stop_before_echo() {
  const double speed = std::isfinite(estimate.speed_mps) ? estimate.speed_mps : 0.0;
  if (speed < 0.4) return false;
  const auto echo = heard.ahead(estimate.time_s);
  const double needed = config.body_m + 0.3 + speed * (config.line_overhead_s + config.seconds_per_word + config.reaction_s);
  return echo && *echo < needed && voice.offer(make_cue(CueKind::stop), estimate.time_s);
}

/// The action that tells the likely places best apart. Turning on the spot shows the same walls again and again: every
/// other time it is a step to where the belt hears that it is free, once the wearer stands still.
Cue Guide::Impl::probe_cue(std::span<const Hypothesis> places) {
  constexpr double kStepFree = 1.0;  // metres from the wearer's middle
  constexpr double kStill = 1.2;     // s: directions that were heard hold
  const double now = estimate.time_s;
  guidance::Probe probe = guidance::choose_probe(*router, config.belt, places);
  const bool still = turning.still_for(kStill, now);
  if (probe.action == guidance::Probe::Action::step && !(still && heard.is_free(probe.direction, kStepFree, now))) {
    probe = {guidance::Probe::Action::turn, kPi / 2, 0.0};
  }
  if (probe.action == guidance::Probe::Action::turn && probed_by_turn && still) {
    // On the way that the last step went, however the wearer has turned since: to and fro shows nothing new.
    const double onward = wrap_angle(step_direction - turning.turned());
    if (const auto free = heard.most_free(kStepFree, onward, now)) probe = {guidance::Probe::Action::step, *free, 0.0};
  }
  Cue cue = make_cue(probe.action == guidance::Probe::Action::turn ? CueKind::probe_turn : CueKind::probe_step);
  cue.direction = probe.direction;
  cue.has_direction = true;
  return cue;
}

void Guide::Impl::handle_found() {
  const double now = estimate.time_s;
  if (!told_lost) {
    was_lost = false;
    return;  // it was never said that the place is not known: note_room() names the room
  }
  Cue cue = guidance::room_cue(CueKind::found, estimate.room);
  if (follower.active()) {
    if (!turning.turning()) cue.tail = follower.next_step(estimate);
  } else {
    const Cue door = guidance::nearest_door(*router, estimate);
    if (door.distance_m >= 0.0) cue.tail = {CueKind::door, true, door.direction, -1.0};
  }
  voice.forget_search();
  if (!voice.offer(cue, now, true)) return;
  was_lost = told_lost = false;
  room = estimate.room;
  room_pending = false;
}

void Guide::Impl::note_room() {
  constexpr double kClearlyInside = 0.7;
  if (estimate.room == room || estimate.room_probability < kClearlyInside) return;
  room = estimate.room;
  room_pending = true;
  room_since = estimate.time_s;
}

void Guide::Impl::tell_obstacle() {
  const double now = estimate.time_s;
  if (certainty.level() != Certainty::Level::sure) return;
  obstacles.steady(estimate, [&](Vec2 at) { follower.note_obstacle(estimate, at); });
  const double reach = config.obstacle_m + std::max(0.0, estimate.speed_mps) * (config.reaction_s + 1.2);
  const auto thing = obstacles.nearest(estimate, reach);
  if (!thing.present) return;
  obstacle_m = thing.distance_m;
  if (now - obstacle_told < config.repeat_gap_s) return;
  Cue cue = make_cue(CueKind::obstacle);
  cue.direction = thing.direction;
  cue.has_direction = true;
  cue.distance_m = thing.distance_m;
  if (voice.offer(cue, now)) obstacle_told = now;
}

void Guide::Impl::answer_destination() {
  if (!follower.active()) {
    destination_asked = false;
    return;
  }
  if (follower.route().waypoints.empty()) return;  // no way yet
  Cue cue = make_cue(CueKind::destination);
  cue.sigma_m = estimate.sigma_m;
  cue.distance_m = walked_length(follower.route());
  const Goal& goal = follower.route().goal;
  const auto kind = goal.kind == Goal::Kind::place  ? CueLandmark::Kind::place
                    : goal.kind == Goal::Kind::exit ? CueLandmark::Kind::exit
                    : goal.kind == Goal::Kind::room ? CueLandmark::Kind::room
                                                    : CueLandmark::Kind::none;
  cue.landmark = {kind, goal.index};
  if (kind == CueLandmark::Kind::none || voice.offer(cue, estimate.time_s, true)) destination_asked = false;
}

void Guide::Impl::tell_pending() {
  const double now = estimate.time_s;
  if (destination_asked) answer_destination();
  if (where_asked) {
    where_asked = false;
    asked[0] = guidance::room_cue(CueKind::room_here, estimate.room);
    asked[1] = guidance::facing(*router, estimate);
    asked[2] = guidance::nearest_door(*router, estimate);
    asked[2].urgency = Urgency::asked;
    asked_count = asked[2].distance_m >= 0.0 ? 3 : 2;
    asked_next = 0;
    asked_at = now;
  }
  if (asked_next < asked_count) {
    if (now - asked_at > kAskedFor) asked_next = asked_count;
    else if (voice.is_free(now) && voice.offer(asked[asked_next], now, true)) ++asked_next;
    return;
  }
  if (!room_pending) return;
  const bool told = voice.offer(guidance::room_cue(CueKind::entering, room), now);
  if (told || now - room_since > kPendingFor) room_pending = false;
}

void Guide::Impl::tell_in_passing() {
  if (certainty.level() != Certainty::Level::sure || estimate.speed_mps < 0.2) return;
  const Cue cue = guidance::nearest_passage(*router, estimate);
  if (cue.distance_m > 2.0 * kPassing) told_in_passing = {};
  const bool near = cue.distance_m >= 0.3 && cue.distance_m <= kPassing && std::abs(cue.direction) <= degrees(110.0);
  if (!near || cue.landmark == told_in_passing) return;
  if (voice.is_free(estimate.time_s) && voice.offer(cue, estimate.time_s)) told_in_passing = cue.landmark;
}

/// Whoever is at stairs or an elevator may take them unasked: then echoes need not fit for a while.
void Guide::Impl::note_link() {
  constexpr double kAt = 1.5;  // metres
  if (certainty.level() != Certainty::Level::sure) return;
  maybe_climbing_until = -1e300;
  for (const LevelLink& link : router->building().links) {
    const bool at_a = link.room_a == estimate.room && distance(link.at_a, estimate.pose.position) < kAt;
    const bool at_b = link.room_b == estimate.room && distance(link.at_b, estimate.pose.position) < kAt;
    if (!at_a && !at_b) continue;
    const double patience = link.kind == LevelLinkKind::stairs ? config.stairs_patience_s : config.elevator_patience_s;
    maybe_climbing_until = std::max(maybe_climbing_until, estimate.time_s + config.unasked_share * patience);
  }
}

void Guide::Impl::tell_free_place() {
  if (certainty.level() != Certainty::Level::sure || estimate.speed_mps < 0.2) return;
  const std::vector<Landmark>& places = router->building().places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool here = places[i].room == estimate.room;
    const double away = distance(places[i].at, estimate.pose.position);
    if (!here || away > 2.0 * kFreePlace) told_places[i] = false;
    if (!here || away > kFreePlace || told_places[i] || places[i].name.empty()) continue;
    const Vec2 way = (1.0 / std::max(away, 1e-6)) * (places[i].at - estimate.pose.position);
    constexpr double kItsOwnDepth = 0.3;  // a place may stand on a bench
    if (router->space(estimate.room).reach(estimate.pose.position, way, away) < away - kItsOwnDepth) continue;
    Cue cue = make_cue(CueKind::place);
    cue.landmark = {CueLandmark::Kind::place, static_cast<std::int32_t>(i)};
    cue.direction = guidance::direction_to(estimate.pose, places[i].at);
    cue.has_direction = true;
    cue.distance_m = away;
    cue.sigma_m = estimate.sigma_m;
    if (voice.is_free(estimate.time_s) && voice.offer(cue, estimate.time_s)) told_places[i] = true;
  }
}

void Guide::Impl::drop_crumb() {
  if (certainty.level() != Certainty::Level::sure) return;
  const Spot here{estimate.room, estimate.pose.position};
  if (!crumbs.empty() && crumbs.back().room == here.room && distance(crumbs.back().at, here.at) < kCrumbSpacing) return;
  if (crumbs.size() == kCrumbs) {  // a very long walk: every other crumb still shows the way
    std::size_t kept = 0;
    for (std::size_t i = 0; i < crumbs.size(); i += 2) crumbs[kept++] = crumbs[i];
    crumbs.resize(kept);
  }
  crumbs.push_back(here);
}

}  // namespace echoway
