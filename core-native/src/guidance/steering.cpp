#include "guidance/steering.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/side_step.hpp"
#include "guidance/spoken_turn.hpp"
#include "guidance/surroundings.hpp"

namespace echoway::guidance {
namespace {

/// A wearer who is to go straight is put right first if they face this far off.
constexpr double kFacingWell = degrees(9.0);
/// Less than this is no use saying, whatever it leads to.
constexpr double kWorthBending = degrees(4.0);
/// Walkers who are off by more than this are turned, by less they bear to a side.
constexpr double kMostBend = degrees(22.0);

/// What a turn must leave free: to who walks, to who stands, which is where they have been for a while, and in a tight
/// spot.
constexpr Demand kWalking{};
constexpr Demand kStanding{0.55, 1.5};
constexpr Demand kTight{0.5, 1.0, false};
/// Who stands there for so long without a word is sent to where there is more room, or turned all the same, seconds.
constexpr double kStuck = 2.0;
constexpr double kQuiteStuck = 8.0;

}  // namespace

void Steering::forget() noexcept {
  pacing_ = {};
  stretch_.forget();
  frame_.forget();
}

void Steering::tell_again() noexcept {
  pacing_.straight_due = true;
  pacing_.hold_until = -1e300;
}

bool Steering::watch_stretch(const View& view) noexcept {
  constexpr double kAhead = 0.35;  // from the wearer's middle to what was touched, metres
  switch (stretch_.watch(view, pacing_.hold_until)) {
    case Stretch::Outcome::open:
      break;
    case Stretch::Outcome::short_of:
      return true;
    case Stretch::Outcome::met:
      if (frame_.meet(view, *way_)) {
        note_frame();
        return true;
      }
      way_->hindrances().touch(view.estimate->room, view.estimate->pose, kAhead, view.now);
      break;
    case Stretch::Outcome::not_begun:
      begin_leg();
      break;
  }
  return false;
}

void Steering::note_frame() noexcept {
  begin_leg();
  pacing_.door_due = true;
}

bool Steering::point_to_door(const View& view, Announcer& voice) {
  // Once an instruction: who stands hears the same again and again.
  if (!view.walking && pacing_.last_said >= frame_.last_met() && frame_.hear(view, *way_)) note_frame();
  const LinePoint* door = way_->first_door().door;
  if (!pacing_.door_due || door == nullptr || !voice.is_free(view.now)) return false;
  pacing_.door_due = false;
  Cue cue = make_cue(CueKind::door);
  cue.urgency = Urgency::turn;  // where to go then does not cut it off
  cue.direction = direction_to(view.estimate->pose, door->at);
  cue.has_direction = true;
  return sector_of(cue.direction) != Sector::ahead && voice.offer(cue, view.now);
}

void Steering::hold_after(const Cue& cue, const View& view) {
  const bool only_stops = cue.kind == CueKind::stop && cue.tail.kind != CueKind::turn;
  if (only_stops) stretch_.stop(view.now);
  else if (cue.kind != CueKind::bear) stretch_.forget();
  if (cue.kind != CueKind::stop || cue.tail.present) aim_->keep(view);
  const double turn = cue.tail.present ? cue.tail.direction : cue.direction;
  const double turning = cue.kind == CueKind::turn || cue.tail.present ? 0.6 + std::abs(turn) / degrees(90.0) : 0.6;
  pacing_.hold_until = view.now + spoken_seconds(cue, *config_) + reaction_->seconds() + turning;
  pacing_.last_said = view.now;
}

bool Steering::halt(const View& view, Announcer& voice) {
  if (!view.walking || view.vague) return false;
  const Pose2& pose = view.estimate->pose;
  Cue cue = make_cue(CueKind::stop);
  const double lead = reaction_->way(cue, view.speed) + 0.2 * view.speed;
  const double free = router_->space(view.estimate->room).reach(pose.position, unit_from_angle(pose.heading), 10.0);
  if (free - config_->body_m > lead) return false;
  // On the way to a spot before that wall, where the wearer was told to go.
  if (std::abs(view.off) <= config_->ahead_rad && view.target_away < free - config_->body_m) return false;
  return (put_safe_turn_in_tail(view, cue) && say_stop(view, cue, voice)) || stop_walker(view, voice);
}

/// "Stop. Turn left.", if that can be done where they will stand. `cue`: "Stop."
bool Steering::put_safe_turn_in_tail(const View& view, Cue& cue) const {
  const double turn = told(view.off);
  if (sector_of(turn) == Sector::ahead || !outlook_.clear_ahead(view, cue, understood(turn), {})) return false;
  put_turn_in_tail(cue, CueKind::stop, turn);
  return true;
}

bool Steering::say_stop(const View& view, const Cue& cue, Announcer& voice) {
  if (!voice.offer(cue, view.now)) return false;
  begin_leg();
  hold_after(cue, view);
  return true;
}

/// "Stop." once in a while; sooner after the last one other words: "Stop. Turn left.", "Stop. Door left.",
/// "Stop. Facing the wall."
bool Steering::stop_walker(const View& view, Announcer& voice) {
  const Cue plain = make_cue(CueKind::stop);
  if (say_stop(view, plain, voice)) return true;
  Cue cue = plain;
  if (put_safe_turn_in_tail(view, cue) && say_stop(view, cue, voice)) return true;
  if (const LinePoint* door = way_->first_door().door) {
    cue.tail = {CueKind::door, true, direction_to(view.estimate->pose, door->at), -1.0};
    if (say_stop(view, cue, voice)) return true;
  }
  cue.tail = {CueKind::facing, true, 0.0, -1.0};
  return say_stop(view, cue, voice);
}

/// A turn would face the wearer with a wall. Walkers are stopped first, where it is to be made. Whoever stands is sent
/// another way by a step or two, from where the turn can be told.
bool Steering::turn_in_tight_spot(const View& view, const Demand& demand, Announcer& voice) {
  if (view.walking) {
    const double lead = reaction_->way(make_cue(CueKind::stop), view.speed);
    if (view.at_turn && view.turn.distance > lead) return true;  // not yet
    return stop_walker(view, voice) || !voice.is_free(view.now);
  }
  if (view.pace > 0.0) return true;  // they will walk on
  const auto step = find_side_step(*router_, *config_, outlook_, *aim_, *way_, view, demand);
  if (!step) return false;
  (void)say_step(view, *step, voice);  // or soon
  return true;
}

bool Steering::say_step(const View& view, const SideStep& step, Announcer& voice) {
  constexpr double kPace = 0.7;  // m/s
  Cue cue = make_cue(step.direction == 0.0 ? CueKind::go_straight : CueKind::turn);
  if (step.direction == 0.0) {
    cue.distance_m = step.length_m;
  } else {
    cue.direction = step.direction;
    cue.has_direction = true;
    cue.tail = {CueKind::go_straight, true, 0.0, step.length_m};
  }
  if (!voice.offer(cue, view.now)) return false;
  begin_leg();
  hold_after(cue, view);
  pacing_.hold_until += step.length_m / kPace;
  return true;
}

/// True when the turn cannot be told as it stands, because of walls: something else has been, or it has to wait.
bool Steering::is_kept_from_turning(const View& view, const Cue& cue, double direction, Announcer& voice) {
  if (hears_wall(view, understood(direction)) && look_round(view, voice)) return true;
  const bool again = view.walking && voice.is_free(view.now) && !voice.would_speak(cue, view.now);
  if (again && turn_in_tight_spot(view, {}, voice)) return true;
  const auto clear = [&](const Demand& demand) {
    return outlook_.clear_ahead(view, cue, understood(direction), demand);
  };
  const Demand& first = view.walking ? kWalking : kStanding;
  if (clear(first) || hears_free(view, understood(direction), cue)) return false;
  if (!view.walking && is_settling(view)) return true;
  if (turn_in_tight_spot(view, first, voice)) return true;
  if (view.walking) return true;  // rather nothing than towards a wall
  // In a tight spot less must do, after a while.
  if (clear(kTight)) return false;
  if (!is_stuck(view, kStuck) || leave_tight_spot(view, voice)) return true;
  return !is_stuck(view, kQuiteStuck) || look_round(view, voice);
}

/// Whether the belt hears, whatever the place is, that it is free where the wearer, who stands, is to go, and the plan
/// has no wall there as long as the place is right; before a door the next room is enough, for the door's wall would
/// answer sooner. Beside a wall or a door's frame only what is sure to be free is taken to be: a wall that near may not
/// be heard.
bool Steering::hears_free(const View& view, double direction, const Cue& cue) const {
  constexpr double kFree = 1.0;      // metres
  constexpr double kByAWall = 0.45;  // metres
  constexpr Demand kByThePlan{0.5, 0.0};
  if (view.walking) return false;
  const Estimate& e = *view.estimate;
  if (router_->space(e.room).clearance(e.pose.position, kByAWall) < kByAWall) return false;
  const bool open = heard_->is_open(direction, kFree, view.now) || frame_.hears_through(view, *way_, direction);
  return open && outlook_.clear_ahead(view, cue, direction, kByThePlan);
}

/// Whether the belt itself hears a wall where the wearer, who stands, is to go: one that the plan has elsewhere, or a
/// thing. The way is laid round it.
bool Steering::hears_wall(const View& view, double direction) {
  constexpr double kFree = 0.5;  // metres
  if (view.walking) return false;
  const auto wall = heard_->wall(direction, view.now);
  if (!wall || *wall >= kFree) return false;
  const Pose2& pose = view.estimate->pose;
  const Pose2 turned{pose.position, wrap_angle(pose.heading + direction)};
  way_->hindrances().stand_before(view.estimate->room, turned, *wall, view.now);
  return true;
}

/// Who stands where nothing can be told that is sure not to point at a wall waits, for a better place or another way,
/// and then turns slowly: that shows where they are. True while that is all there is to say; once in a while.
bool Steering::look_round(const View& view, Announcer& voice) {
  constexpr double kPause = 30.0;  // s
  constexpr double kTakes = 7.0;   // s
  if (view.now - pacing_.looked_round < kPause) return false;
  if (!is_stuck(view, kQuiteStuck)) return true;
  Cue cue = make_cue(CueKind::probe_turn);
  cue.direction = std::copysign(kPi / 2, view.off);
  cue.has_direction = true;
  if (!voice.offer(cue, view.now)) return true;
  begin_leg();
  hold_after(cue, view);
  pacing_.hold_until += kTakes;
  pacing_.looked_round = view.now;
  return true;
}

/// Whether the wearer has just stopped and will soon be known better.
bool Steering::is_settling(const View& view) noexcept {
  constexpr double kWellKnown = 0.15;  // metres
  constexpr double kSettles = 3.0;     // s
  return view.estimate->sigma_m > kWellKnown && view.now - view.still_since < kSettles;
}

/// Whether the wearer has stood for so long without a word.
bool Steering::is_stuck(const View& view, double seconds) const noexcept {
  return view.now - std::max({view.still_since, pacing_.last_said, pacing_.hold_until}) > seconds;
}

/// To where there is more room, if not on the way.
bool Steering::leave_tight_spot(const View& view, Announcer& voice) {
  const auto step = find_room(*router_, *config_, outlook_, *way_, view, kTight);
  return step && say_step(view, *step, voice);
}

void Steering::word_turn(const View& view, double direction, const Announcer& voice, Cue& cue) const {
  constexpr double kBack = degrees(100.0);
  if (way_->is_new()) {
    put_turn_in_tail(cue, CueKind::rerouted, direction);
  } else if (way_->is_astray(view.estimate->sigma_m) && std::abs(view.off) > kBack) {
    put_turn_in_tail(cue, CueKind::wrong_way, direction);
  }
  if (cue.kind != CueKind::turn || voice.would_speak(cue, view.now)) return;
  // The same words were said a moment ago and did not do, or are needed again: more words make them new. A walker is
  // told how it goes on; whoever stands has to be put right first.
  if (view.walking && view.at_turn) {
    cue.tail = {CueKind::go_straight, true, 0.0, view.turn.run_out};
    return;
  }
  put_turn_in_tail(cue, CueKind::stop, direction);
  cue.urgency = Urgency::turn;
}

bool Steering::say_turn(const View& view, Announcer& voice) {
  const double direction = told(view.off);
  Cue cue = make_cue(CueKind::turn);
  cue.direction = direction;
  cue.has_direction = true;
  if (is_kept_from_turning(view, cue, direction, voice)) return true;
  word_turn(view, direction, voice, cue);
  if (!voice.offer(cue, view.now)) return false;
  reaction_->time(cue, view.estimate->pose.heading, view.now);
  way_->told_new();
  way_->forget_progress();
  pacing_.straight_due = !(cue.tail.present && cue.tail.kind == CueKind::go_straight);
  hold_after(cue, view);
  return true;
}

/// Who stands and faces a little off, on a vague place, would never set out: they are turned where only the echoes do
/// not fit, else they turn slowly.
bool Steering::face_way(const View& view, Announcer& voice) {
  const bool narrow = view.estimate->sigma_m <= config_->vague_sigma_m;
  return narrow && is_stuck(view, kQuiteStuck) ? say_turn(view, voice) : look_round(view, voice);
}

bool Steering::turn(const View& view, Announcer& voice) {
  const double off = std::abs(view.off);
  if (view.vague && off <= degrees(45.0)) return !view.walking && off > config_->ahead_rad && face_way(view, voice);
  if (off > config_->ahead_rad && (!view.walking || view.at_turn || off > degrees(35.0))) return say_turn(view, voice);
  if (!view.walking || view.vague || view.at_turn) return false;
  // Walking a little off: only what would miss the next point by too much is worth a word.
  const double noise = 2.0 * std::min(view.estimate->sigma_heading_rad, degrees(5.0));
  const double miss = view.target_away * std::sin(std::min(off, kPi / 2));
  const bool misses = off >= degrees(6.0) + 0.5 * noise && miss >= view.room_to_miss;
  if (!misses && !(off >= kWorthBending && outlook_.grazes(view))) return false;
  return off > kMostBend ? say_turn(view, voice) : say_bend(view, voice);
}

bool Steering::say_bend(const View& view, Announcer& voice) {
  Cue cue = make_cue(CueKind::bear);
  cue.direction = view.off;
  cue.has_direction = true;
  const double needed = reaction_->way(cue, view.speed);
  // Left alone when a turn to the other side is due so soon that it would have to wait for this to be forgotten.
  const double turn_off = wrap_angle(view.turn.heading - view.estimate->pose.heading);
  const bool countered = view.turn.present && turn_off * view.off < 0.0 &&
                         view.turn.distance < view.speed * config_->contradiction_gap_s + needed;
  if (countered || view.target_away < needed || !voice.offer(cue, view.now)) return false;
  hold_after(cue, view);
  return true;
}

double Steering::length_to_tell(const View& view) const {
  const double along = view.turn.present ? view.turn.distance : length_of(way_->line());
  if (view.at_turn) return along + view.turn.run_out;
  return view.turn.present && along < kAtHand ? view.target_away : along;
}

/// `amend`: who stands and faces a little off bears to that side first.
Cue Steering::straight_cue(const View& view, double along, bool amend) const {
  Cue cue = make_cue(CueKind::go_straight);
  cue.sigma_m = view.estimate->sigma_m;
  if (!way_->is_new() && !amend) {
    cue.distance_m = along;
    return cue;
  }
  cue.kind = amend ? CueKind::bear : CueKind::rerouted;
  cue.tail = {CueKind::go_straight, true, 0.0, along};
  if (amend) {
    cue.direction = view.off;
    cue.has_direction = true;
  }
  return cue;
}

bool Steering::go_on(const View& view, Announcer& voice) {
  const bool stands = !view.walking && view.now - std::max(view.still_since, pacing_.last_said) > config_->nudge_s;
  if (!(pacing_.straight_due || stands) || std::abs(view.off) > config_->ahead_rad) return false;
  const bool amend = !view.walking && !view.vague && !way_->is_new() && std::abs(view.off) > kFacingWell;
  const double along = length_to_tell(view);
  const Cue plain = make_cue(CueKind::go_straight);
  if (view.walking && along < reaction_->way(plain, view.speed)) return false;
  const bool stuck = !view.walking && is_stuck(view, kQuiteStuck);
  const Demand& most = view.walking ? kWalking : stuck ? kTight : kStanding;
  const Demand demand{std::min(most.free_m, 0.8 * along), most.sigmas};
  const Outlook::Approach way = outlook_.approach(view, plain, demand);
  const double direction = amend ? view.off : 0.0;
  const bool clear = outlook_.clear_of_walls(view, way, direction, demand) || hears_free(view, direction, plain);
  if (!clear) return !view.walking && look_round(view, voice);
  if (hears_wall(view, direction) && look_round(view, voice)) return true;
  // Of things only some points are known, not quite where they are: who gets nowhere goes on by touch.
  if (!amend && !stuck && !outlook_.clear_of_things(view, way, direction, demand)) return false;
  const Cue cue = straight_cue(view, along, amend);
  if (!voice.offer(cue, view.now)) return false;
  way_->told_new();
  pacing_.straight_due = false;
  stretch_.tell(view, along);
  pacing_.hold_until = view.now + spoken_seconds(cue, *config_) + reaction_->seconds() + (amend ? 0.8 : 0.4);
  pacing_.last_said = view.now;
  return true;
}

CueTail Steering::as_tail(const View& view, const Cue& line, const Announcer& voice, bool asked) {
  begin_leg();
  way_->told_new();
  if (view.walking || std::abs(view.off) <= config_->ahead_rad) return {};
  if (!outlook_.clear_ahead(view, make_cue(CueKind::turn), understood(view.off), {})) return {};
  Cue whole = line;
  whole.tail = {CueKind::turn, true, view.off, -1.0};
  if (!voice.would_speak(whole, view.now, asked)) return {};  // it takes back another turn
  hold_after(whole, view);
  return whole.tail;
}

}  // namespace echoway::guidance
