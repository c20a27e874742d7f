#include "guidance/follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoway::guidance {
namespace {

constexpr double kFastest = 2.0;  // m/s that anybody walks by cues

bool walks(const Estimate& e) {
  constexpr double kWalking = 0.25;  // m/s
  return e.speed_mps > kWalking;
}

}  // namespace

Follower::Follower(const Router& router, const GuideConfig& config, const HeardSpace& heard)
    : config_(&config),
      way_(router, config),
      reaction_(config),
      aim_(router, config, way_, reaction_),
      steering_(router, config, way_, aim_, reaction_, heard),
      arrival_(router, config, way_, reaction_),
      levels_(router, config, way_),
      herald_(router, config, way_, reaction_, levels_) {}

void Follower::lead_to(RouteTree tree) {
  forget_told();
  way_.lead_to(std::move(tree));
}

void Follower::lead_back(std::vector<Spot> crumbs) {
  forget_told();
  way_.lead_back(std::move(crumbs));
}

void Follower::stop() {
  forget_told();
  way_.clear();
}

void Follower::start_over() {
  forget_told();
  levels_.drop_transition();
  reaction_.stop_watching();
  way_.start_over();
}

void Follower::forget_told() {
  next_look_ = feels_until_ = -1e300;
  aim_.forget();
  steering_.forget();
  arrival_.forget();
  levels_.forget();
  herald_.forget();
  headway_.forget();
  doubt_ = false;
}

bool Follower::find_way(const Estimate& e) {
  if (!way_.find(e)) return false;
  if (way_.has_changed()) steering_.begin_leg();
  return true;
}

View Follower::look(const Estimate& e, const Trust& trust) {
  View view;
  view.estimate = &e;
  view.now = e.time_s;
  view.vague = trust.vague;
  view.unproven = trust.unproven;
  view.speed = std::isfinite(e.speed_mps) ? std::clamp(e.speed_mps, 0.0, kFastest) : 0.0;
  view.walking = walks(e);
  if (!view.walking) view.speed = 0.0;
  if (view.walking) last_pace_ = view.speed;
  view.pace = view.walking || view.now >= feels_until_ ? view.speed : last_pace_;
  view.remaining = walked_length(way_.route());
  view.turn = next_manoeuvre(way_.line(), config_->ahead_rad, config_->fuse_m);
  aim_.take(view);
  return view;
}

void Follower::note_feeling(const Cue& obstacle, const Estimate& e) noexcept {
  constexpr double kFeels = 4.5;  // s after the line and the reaction to it
  if (!was_walking_) return;
  feels_until_ = e.time_s + spoken_seconds(obstacle, *config_) + reaction_.seconds() + kFeels;
}

void Follower::tell_again() noexcept {
  steering_.tell_again();
  next_look_ = -1e300;
}

void Follower::note_standing(View& view) noexcept {
  if (view.walking || was_walking_ != view.walking || !seen_) still_since_ = view.now;
  seen_ = true;
  was_walking_ = view.walking;
  view.still_since = still_since_;
}

void Follower::note_headway(const View& view) noexcept {
  if (view.unproven && steering_.has_met_frame(view.now)) {   // There is a wall where the door should be.
    headway_.start_over();
    doubt_ = true;
  }
  if (headway_.update(view.now, way_.route().cost, steering_.last_said())) doubt_ = true;
}

bool Follower::is_on_stairs(const Estimate& e, Announcer& voice) noexcept {
  if (!levels_.is_under_way()) return false;
  if (!levels_.ends(e)) return true;
  steering_.begin_leg();
  voice.forget_instruction();
  return false;
}

LevelChange::Asked Follower::ask_between_levels(const Estimate& e) {
  const LevelChange::Asked asked = levels_.ask(e);
  if (asked != LevelChange::Asked::again) steering_.begin_leg();
  return asked;
}

void Follower::tell_no_way(double now, Announcer& voice) {
  if (now - steering_.last_said() <= 3.0 * config_->repeat_gap_s) return;
  if (voice.offer(make_cue(CueKind::no_way), now)) steering_.note_said(now);
}

/// After "arrived" the way is kept for a moment: a wearer who has not taken it in walks on and is led back.
bool Follower::lingers(const View& view) {
  switch (arrival_.after(view)) {
    case Arrival::After::not_told:
      return false;
    case Arrival::After::settling:
      return true;
    case Arrival::After::done:
      stop();
      return true;
    case Arrival::After::walked_on:
      steering_.begin_leg();
      break;
  }
  return false;
}

void Follower::update(const Estimate& newest, const Trust& trust, bool turning, Announcer& voice) {
  reaction_.watch(newest);
  const Estimate tracked = standing_.settle(newest, walks(newest));
  steering_.watch_place(tracked, walks(newest));
  const Estimate e = steering_.place(tracked);
  if (!active() || e.time_s < next_look_ || is_on_stairs(e, voice)) return;
  next_look_ = e.time_s + config_->renew_s;
  if (!find_way(e)) {
    tell_no_way(e.time_s, voice);
    return;
  }
  arrival_.note_room(e);
  View view = look(e, trust);
  way_.note_progress();
  note_standing(view);
  const bool waits = steering_.watch_stretch(view);
  note_headway(view);
  herald_.note_way();
  if (!lingers(view) && !waits) lead_on(view, turning, voice);
}

void Follower::lead_on(const View& view, bool turning, Announcer& voice) {
  const bool holding = steering_.is_holding(view.now);
  const Arrival::Now arrival = arrival_.tell(view, holding, voice);
  if (arrival == Arrival::Now::doubtful) doubt_ = true;
  if (arrival == Arrival::Now::walks_past) steering_.stop(view, voice);
  if (arrival != Arrival::Now::elsewhere || levels_.take(view, voice) || holding) return;
  if (steering_.point_to_door(view, voice) || steering_.halt(view, voice) || turning) return;
  if (steering_.turn(view, voice) || steering_.go_on(view, voice)) return;
  herald_.tell(view, voice);
}

std::optional<double> Follower::direction_from(const Estimate& e) {
  const auto heading = way_.heading_from(e);
  return heading ? std::optional(wrap_angle(*heading - e.pose.heading)) : std::nullopt;
}

CueTail Follower::next_step(const Estimate& e, const Cue& line, const Announcer& voice, bool asked) {
  const Estimate here = steering_.place(e);
  if (!active() || !find_way(here)) return {};
  return steering_.as_tail(look(here, {}), line, voice, asked);
}

}  // namespace echoway::guidance
