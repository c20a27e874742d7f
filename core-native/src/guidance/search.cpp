#include "guidance/search.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/probe.hpp"
#include "guidance/spoken_turn.hpp"

namespace echoway::guidance {
namespace {

constexpr double kStep = 0.6;      ///< Metres.
constexpr double kStepFree = 1.0;  ///< From the wearer's middle, for a step, metres.
constexpr double kTurnTakes = 2.5;  ///< s, its words too.

}  // namespace

void Search::begin() noexcept {
  on_ = true;
  told_ = false;
  since_ = -1.0;
  next_request_ = off_by_ = -1e300;
}

bool Search::update(const Estimate& e, std::span<const Hypothesis> places, std::optional<double> wanted, bool starting,
                    bool asked, Announcer& voice) {
  constexpr double kStartPatience = 3.0;  // s
  const double now = e.time_s;
  if (!on_ || since_ < 0.0) since_ = now;
  on_ = true;
  if (starting && now - since_ < kStartPatience && !asked) return false;
  if (!told_ || asked) return tell_uncertain(now, asked, voice);
  if (stop_before_echo(e, voice) || now < next_request_) return false;
  const Cue cue = next_request(now, places, wanted);
  if (voice.offer_search(cue, now)) note_request(cue, now);
  return false;
}

void Search::note_request(const Cue& cue, double now) noexcept {
  constexpr double kPace = 0.7;    // m/s
  constexpr double kIsSeen = 1.0;  // s from the first step
  if (cue.kind == CueKind::probe_turn) {
    moves_ = 0;
    off_by_ = -1e300;
    next_request_ = now + config_->probe_gap_s;
    return;
  }
  ++moves_;
  const double turns = cue.kind == CueKind::turn ? std::abs(cue.direction) / degrees(90.0) : 0.0;
  off_by_ = now + spoken_seconds(cue, *config_) + config_->reaction_s + turns + kIsSeen;
  step_direction_ = wrap_angle((cue.kind == CueKind::turn ? cue.direction : 0.0) + turning_->turned());
  const double length = std::max({cue.distance_m, cue.tail.distance_m, kStep});
  next_request_ = now + config_->step_gap_s + (length - kStep) / kPace + (cue.kind == CueKind::turn ? kTurnTakes : 0.0);
}

bool Search::tell_uncertain(double now, bool asked, Announcer& voice) {
  if (!voice.offer(make_cue(CueKind::uncertain), now, asked)) return false;
  told_ = true;
  moves_ = 0;
  next_request_ = now + config_->probe_gap_s;
  return true;
}

/// Who is lost and walks on all the same is kept from what the belt hears before them.
bool Search::stop_before_echo(const Estimate& e, Announcer& voice) const {
  constexpr double kWalks = 0.4;   // m/s
  constexpr double kMargin = 0.3;  // metres
  const double speed = std::isfinite(e.speed_mps) ? e.speed_mps : 0.0;
  if (speed < kWalks) return false;
  const auto echo = heard_->ahead(e.time_s);
  const Cue stop = make_cue(CueKind::stop);
  const double needed = config_->body_m + kMargin + speed * (spoken_seconds(stop, *config_) + config_->reaction_s);
  return echo && *echo < needed && voice.offer(stop, e.time_s);
}

/// Turning on the spot shows the same walls again and again: in between it is a walk to where the belt hears that it is
/// free, once the wearer stands still.
Cue Search::next_request(double now, std::span<const Hypothesis> places, std::optional<double> wanted) const {
  constexpr double kStill = 1.2;   // s: directions that were heard hold
  constexpr int kMoves = 3;        // before the next slow turn
  constexpr double kBack = degrees(100.0);
  const Probe probe = choose_probe(*router_, config_->belt, places);
  Cue turn = make_cue(CueKind::probe_turn);
  turn.direction = probe.action == Probe::Action::turn ? probe.direction : kPi / 2;
  turn.has_direction = true;
  if (moves_ >= kMoves || !turning_->still_for(kStill, now)) return turn;
  // On the way that the last walk went, however the wearer has turned since: to and fro shows nothing new.
  const double onward = wrap_angle(step_direction_ - turning_->turned());
  const auto way = heard_->way(probe.direction, now);
  const bool tells =
      probe.action == Probe::Action::step && way && *way > kStepFree && heard_->answers(probe.direction, now);
  if (tells && std::abs(wrap_angle(probe.direction - onward)) < kBack) return move_to(probe.direction, now, places);
  const auto free = freest(wanted.value_or(onward), now, places);
  return free ? move_to(*free, now, places) : turn;
}

/// Of the directions that can be told the one where the way is free farthest; about the preferred one rather than
/// others. One from which nothing answers only where there is no other: there may be a wall right beside the wearer.
/// One where the likely places have a wall counts as much less: it may be too near to be heard, or be taken for a hand.
std::optional<double> Search::freest(double preferred, double now, std::span<const Hypothesis> places) const {
  constexpr double kSame = degrees(46.0);
  constexpr double kRather = 2.0;
  constexpr double kFarEnough = 4.0;  // metres
  constexpr double kSilent = 0.1;
  std::optional<double> best;
  double most = 0.0;
  for (const double direction : kSpokenDirections) {
    const auto way = heard_->way(direction, now);
    if (!way || *way < kStepFree) continue;
    const double off = std::abs(wrap_angle(direction - preferred));
    const double known = heard_->answers(direction, now) ? 1.0 : kSilent;
    const double planned = std::max(kSilent, share_free(direction, places));
    const double worth = known * planned * std::min(*way, kFarEnough) * (off < kSame ? kRather - off / kPi : 1.0);
    if (worth <= most) continue;
    most = worth;
    best = direction;
  }
  return best;
}

/// How likely the plan leaves room for a step there, by the places where the wearer may be; 1 where none is known.
double Search::share_free(double direction, std::span<const Hypothesis> places) const noexcept {
  double all = 0.0;
  double free = 0.0;
  for (const Hypothesis& h : places) {
    if (!router_->building().has_room(h.room) || !is_finite(h.pose)) continue;
    const Vec2 then = unit_from_angle(h.pose.heading + direction);
    all += h.probability;
    if (router_->space(h.room).reach(h.pose.position, then, kStepFree) >= kStep) free += h.probability;
  }
  return all > 0.0 ? free / all : 1.0;
}

/// Facing that way first: a step aside or back looks to whoever counts steps like one ahead.
Cue Search::move_to(double direction, double now, std::span<const Hypothesis> places) const {
  const double length = length_of_move(direction, now, places);
  const bool ahead = sector_of(direction) == Sector::ahead;
  Cue cue = make_cue(!ahead ? CueKind::turn : length > kStep ? CueKind::go_straight : CueKind::probe_step);
  cue.urgency = urgency_of(CueKind::probe_step);
  if (cue.kind == CueKind::go_straight) cue.distance_m = length;
  if (ahead) return cue;
  cue.direction = direction;
  cue.has_direction = true;
  cue.tail = {CueKind::go_straight, true, 0.0, length};
  return cue;
}

/// As far as the belt hears that it is free; no more than a step where there may be stairs, which no echo tells of.
double Search::length_of_move(double direction, double now, std::span<const Hypothesis> places) const {
  constexpr double kMost = 4.0;
  constexpr double kMargin = 0.9;  // from the wearer's middle to what is heard, metres
  const auto way = heard_->way(direction, now);
  const auto near_stairs = [&](const Hypothesis& h) { return is_near_stairs(h); };
  if (!way || std::any_of(places.begin(), places.end(), near_stairs)) return kStep;
  return std::clamp(*way - kMargin, kStep, kMost);
}

bool Search::is_near_stairs(const Hypothesis& place) const {
  constexpr double kNear = 4.0;  // metres
  const auto& links = router_->building().links;
  return std::any_of(links.begin(), links.end(), [&](const LevelLink& l) {
    const bool here = (l.room_a == place.room && distance(l.at_a, place.pose.position) < kNear) ||
                      (l.room_b == place.room && distance(l.at_b, place.pose.position) < kNear);
    return here && l.kind == LevelLinkKind::stairs;
  });
}

}  // namespace echoway::guidance
