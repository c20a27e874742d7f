#include "support/blind_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>

#include "echoway/geometry/box.hpp"
#include "echoway/speech/speaker.hpp"

namespace echoway::test {
namespace {

constexpr double kTick = 0.0624;        // a firing
constexpr double kBody = 0.2;           // contact nearer than this, metres
constexpr double kTurnRate = degrees(90.0);
constexpr double kStorey = 17.0;        // s on stairs: two flights and the landing between,
constexpr double kCabin = 14.0;         // and in an elevator, its coming included,
constexpr double kCabinStorey = 3.0;    // for each level.
constexpr double kStep = 0.6;           // one step, metres
constexpr double kWrongReach = 0.5;     // an instruction towards a wall nearer than this is wrong, metres

/// What a wearer understands by a sector.
double nominal(double direction) {
  switch (sector_of(direction)) {
    case Sector::ahead:
      return 0.0;
    case Sector::slightly_left:
      return degrees(30.0);
    case Sector::slightly_right:
      return degrees(-30.0);
    case Sector::left:
      return degrees(85.0);
    case Sector::right:
      return degrees(-85.0);
    case Sector::sharp_left:
      return degrees(140.0);
    case Sector::sharp_right:
      return degrees(-140.0);
    case Sector::behind:
      break;
  }
  return kPi;
}

/// What a wearer hears of a length: rounded to feet, as it is spoken.
double told_length(double metres) { return 0.5 * spoken_length(metres, 0.1, {}).halves * kMetresPerFoot; }

double line_seconds(const Cue& cue) {
  // Listening, as the guide cannot know it: words of its own voice at its own speed.
  int words = cue.kind == CueKind::uncertain ? 9 : 2;
  if (cue.distance_m >= 0.0) words += 2;
  if (cue.tail.present) words += 2;
  return 0.2 + 0.36 * words;
}

/// The true world and a body in it.
class Body {
 public:
  Body(const Router& router, const Spot& start, double heading, PoseSource& source)
      : router_(router), source_(source), room_(start.room), pose_{start.at, heading} {}

  [[nodiscard]] RoomIndex room() const { return room_; }
  [[nodiscard]] const Pose2& pose() const { return pose_; }
  void turn(double angle) { pose_.heading = wrap_angle(pose_.heading + angle); }
  void set(RoomIndex room, const Pose2& pose) {
    room_ = room;
    pose_ = pose;
  }

  /// Free metres in a direction from the chest, through open doors into the next room.
  [[nodiscard]] double reach(double direction) const {
    return router_.space(room_).reach(pose_.position, unit_from_angle(pose_.heading + direction), 20.0);
  }

  enum class Met : std::uint8_t { nothing, wall, thing };

  /// Moves, unless something is met.
  Met move(double direction, double length) {
    const Vec2 to = pose_.position + length * unit_from_angle(pose_.heading + direction);
    const FreeSpace& space = router_.space(room_);
    const double now = space.clearance(pose_.position);
    const double then = space.clearance(to);
    if (then < kBody && then < now) return Met::wall;
    if (meets_thing(to)) return Met::thing;
    const Segment step{pose_.position, to};
    for (const Passage& p : space.passages()) {
      const Door& door = router_.building().doors[static_cast<std::size_t>(p.door)];
      if (p.inward == Vec2{}) continue;
      const Vec2 along = perpendicular(p.inward);
      const Segment opening{p.centre - 0.5 * door.width * along, p.centre + 0.5 * door.width * along};
      if (dot(to - p.centre, p.inward) >= 0.0 || !intersects(step, opening)) continue;
      enter(p, door, to);
      return Met::nothing;
    }
    pose_.position = to;
    return Met::nothing;
  }

 private:
  void enter(const Passage& p, const Door& door, Vec2 to) {
    const RoomIndex next = door.room_a == room_ ? door.room_b : door.room_a;
    const double turn = router_.building().room(room_).frame.heading - router_.building().room(next).frame.heading;
    for (const Passage& q : router_.space(next).passages()) {
      if (q.door != p.door) continue;
      const Pose2 frame{q.centre, turn};
      const Vec2 offset = frame.transform(to - p.centre);
      pose_ = {offset, wrap_angle(pose_.heading + turn)};
      break;
    }
    room_ = next;
  }

  bool meets_thing(Vec2 to) {
    const auto [known, is_new] = things_.try_emplace(room_);
    if (is_new) known->second = source_.things(room_);
    return std::any_of(known->second.begin(), known->second.end(), [&](const Segment& s) {
      const double then = echoway::distance(s, to);
      return then < kBody && then < echoway::distance(s, pose_.position);
    });
  }

  const Router& router_;
  PoseSource& source_;
  RoomIndex room_;
  Pose2 pose_;
  std::map<RoomIndex, std::vector<Segment>> things_;
};

class Wearer {
 public:
  Wearer(const Router& router, Body& body, const WearerModel& model, Random& random, WalkOutcome& outcome)
      : router_(router), body_(body), model_(model), random_(random), outcome_(outcome) {
    speed_ = random.uniform(model.speed_low, model.speed_high);
    reaction_ = random.uniform(model.reaction_low, model.reaction_high);
    stride_ = 1.0 + random.normal(0.0, model.step_error);
  }

  [[nodiscard]] bool done() const { return done_; }
  [[nodiscard]] double speed() const {
    const bool moves = step_left_ > 0.0 || (walking_ && now_ >= pause_until_);
    return moves && turn_left_ == 0.0 && !away() ? speed_ : 0.0;
  }
  /// Standing about without a word for long: a wearer asks for the last line again.
  [[nodiscard]] bool asks() {
    const bool busy = walking_ || turn_left_ != 0.0 || slow_turn_ > 0.0 || step_left_ > 0.0 || !todo_.empty() || away();
    if (busy || now_ - last_heard_ < model_.patience) return false;
    last_heard_ = now_;
    return true;
  }
  [[nodiscard]] bool away() const { return crossing_now_ && now_ < crossing_.ends_s; }
  [[nodiscard]] const Crossing& crossing() const { return crossing_; }

  void hear(const Cue& cue, double now) {
    last_heard_ = now;
    const bool taken_in = random_.uniform() >= model_.ignore;
    outcome_.cues.push_back({cue, false});
    const std::size_t index = outcome_.cues.size() - 1;
    // Anything that is heard now drops what was not yet acted upon.
    if (!taken_in) return;
    const double delay = line_seconds(cue) + reaction_;
    if (cue.kind == CueKind::rerouted || cue.kind == CueKind::wrong_way || cue.kind == CueKind::stop) {
      todo_.push_back(
          {now + (cue.kind == CueKind::stop ? 0.3 + reaction_ : delay), cue.kind, 0.0, -1.0, index, cue.landmark});
      if (cue.tail.present) {
        todo_.push_back({now + delay, cue.tail.kind, cue.tail.direction, cue.tail.distance_m, index, {}});
      }
      return;
    }
    if (cue.kind == CueKind::arrived) {  // the first word says it
      todo_.push_back({now + 0.7 + reaction_, cue.kind, 0.0, -1.0, index, {}});
      return;
    }
    todo_.push_back({now + delay, cue.kind, cue.direction, cue.distance_m, index, cue.landmark, cue.up});
    if (cue.tail.present) {
      todo_.push_back({now + delay + 0.1, cue.tail.kind, cue.tail.direction, cue.tail.distance_m, index, {}});
    }
  }

  void live(double now) {
    now_ = now;
    if (away()) return;
    if (crossing_now_) land();
    while (!todo_.empty() && now >= todo_.front().at && turn_left_ == 0.0) {
      const Act act = todo_.front();
      todo_.pop_front();
      do_it(act);
    }
    if (turn_left_ != 0.0) {
      const double step = std::clamp(turn_left_, -kTurnRate * kTick, kTurnRate * kTick);
      body_.turn(step);
      turn_left_ = std::abs(turn_left_ - step) < 1e-9 ? 0.0 : turn_left_ - step;
      return;
    }
    if (slow_turn_ > 0.0) {
      body_.turn(slow_side_ * degrees(30.0) * kTick);
      slow_turn_ -= degrees(30.0) * kTick;
      return;
    }
    if (step_left_ > 0.0) {
      step();
      return;
    }
    if (walking_ && now >= pause_until_) walk();
  }

 private:
  struct Act {
    double at;
    CueKind kind;
    double direction;
    double distance;
    std::size_t cue;
    CueLandmark landmark;
    bool up = false;
  };

  void walk() {
    const double length = speed_ * kTick;
    body_.turn(random_.normal(0.0, model_.veer) * std::sqrt(length));
    const Body::Met met = body_.move(0.0, length);
    if (met != Body::Met::nothing) {
      ++(met == Body::Met::wall ? outcome_.touches : outcome_.bumps);
      walking_ = false;
      body_.move(kPi, 0.15);  // steps back from what was touched
      return;
    }
    outcome_.walked_m += length;
    budget_ -= length;
    if (budget_ <= 0.0) walking_ = false;  // nothing has been said for longer than was told: wait
  }

  /// A step aside, back or ahead without turning.
  void step() {
    const double length = std::min(speed_ * kTick, step_left_);
    step_left_ -= length;
    const Body::Met met = body_.move(step_direction_, length);
    if (met == Body::Met::nothing) return;
    ++(met == Body::Met::wall ? outcome_.touches : outcome_.bumps);
    step_left_ = 0.0;
  }

  void judge(std::size_t cue, double direction, double need) {
    ++outcome_.instructions;
    HeardCue& heard = outcome_.cues[cue];
    heard.acted_room = body_.room();
    heard.acted = body_.pose();
    heard.wanted = direction;
    heard.reach = body_.reach(direction);
    if (heard.reach >= need) return;
    heard.wrong = true;
    ++outcome_.wrong_cues;
  }

  void start_turn(double wanted, std::size_t cue) {
    judge(cue, wanted, kWrongReach);
    turn_left_ = wanted * (1.0 + random_.normal(0.0, 0.1));
    turn_left_ += random_.normal(0.0, model_.turn_sigma * std::min(1.0, std::abs(wanted)));
    slow_turn_ = 0.0;
    budget_ = std::max(budget_, 1.5);
  }

  void do_it(const Act& act) {
    switch (act.kind) {
      case CueKind::turn:
        if (nominal(act.direction) == 0.0) return;
        start_turn(nominal(act.direction), act.cue);
        return;
      case CueKind::bear:
        body_.turn((act.direction > 0.0 ? 1.0 : -1.0) * degrees(13.0) * (1.0 + random_.normal(0.0, 0.25)));
        ++outcome_.instructions;
        return;
      case CueKind::go_straight:
        judge(act.cue, 0.0, act.distance < 0.0 ? kWrongReach : std::min(0.8 * act.distance, kWrongReach));
        walking_ = true;
        slow_turn_ = 0.0;
        // Counts the steps told, and a little more, then waits for the next word.
        budget_ = (act.distance < 0.0 ? 3.0 : told_length(act.distance)) * stride_ + 0.15;
        return;
      case CueKind::stop:
        walking_ = false;
        return;
      case CueKind::obstacle:  // feels for it, then goes on
        pause_until_ = now_ + 3.0;
        return;
      case CueKind::uncertain:
        walking_ = false;
        slow_side_ = 1.0;
        slow_turn_ = kTwoPi;
        return;
      case CueKind::probe_turn:
        walking_ = false;
        slow_side_ = act.direction > 0.0 ? 1.0 : -1.0;
        slow_turn_ = degrees(180.0);
        return;
      case CueKind::probe_step:
        slow_turn_ = 0.0;
        walking_ = false;
        judge(act.cue, act.direction, kStep);
        step_left_ = kStep;
        step_direction_ = act.direction;
        return;
      case CueKind::found:
        slow_turn_ = 0.0;
        return;
      case CueKind::arrived:
        walking_ = false;
        done_ = true;
        return;
      case CueKind::take_link:
        ride(act);
        return;
      default:
        return;
    }
  }

  void ride(const Act& act) {
    const auto index = static_cast<std::size_t>(act.landmark.index);
    const LevelLink& link = router_.building().links[index];
    const bool from_a = body_.room() == link.room_a && distance(body_.pose().position, link.at_a) < 2.0;
    const bool from_b = body_.room() == link.room_b && distance(body_.pose().position, link.at_b) < 2.0;
    walking_ = false;
    if (!from_a && !from_b) return;
    // Who has gone up already and hears "up" again finds no stairs up.
    const RoomIndex next = link.beyond(body_.room());
    if ((router_.building().room(next).level > router_.building().room(body_.room()).level) != act.up) return;
    Crossing& c = crossing_;
    c.link = index;
    c.from = body_.room();
    c.leaving = body_.pose();
    c.to = next;
    const Room& here = router_.building().room(c.from);
    const Room& there = router_.building().room(c.to);
    const Vec2 at = router_.space(c.to).settle(from_a ? link.at_b : link.at_a, 0.4);
    // Who has turned on the half-landing or in the cabin comes out facing back.
    c.arriving = {at, wrap_angle(c.leaving.heading + here.frame.heading - there.frame.heading + kPi)};
    const int storeys = std::max(1, std::abs(there.level - here.level));
    c.begins_s = now_;
    c.ends_s = now_ + (link.kind == LevelLinkKind::stairs ? kStorey * storeys : kCabin + kCabinStorey * storeys);
    crossing_now_ = true;
  }

  void land() {
    crossing_now_ = false;
    last_heard_ = now_;
    body_.set(crossing_.to, crossing_.arriving);
    turn_left_ = random_.normal(0.0, degrees(15.0));  // nobody steps off quite straight
  }

  const Router& router_;
  Body& body_;
  const WearerModel& model_;
  Random& random_;
  WalkOutcome& outcome_;
  double speed_ = 0.8;
  double reaction_ = 0.8;
  double stride_ = 1.0;
  std::deque<Act> todo_;
  bool walking_ = false;
  bool done_ = false;
  double turn_left_ = 0.0;
  double slow_turn_ = 0.0;
  double slow_side_ = 1.0;
  double budget_ = 0.0;
  double step_left_ = 0.0;
  double step_direction_ = 0.0;
  double now_ = 0.0;
  double last_heard_ = 0.0;
  double pause_until_ = -1.0;
  Crossing crossing_;
  bool crossing_now_ = false;
};

}  // namespace

void NoisyTruth::observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) {
  const double keep = std::exp(-kTick / 3.0);
  const double add = std::sqrt(1.0 - keep * keep);
  error_ = keep * error_ + add * sigma_m_ * Vec2{random_.normal(), random_.normal()};
  heading_error_ = keep * heading_error_ + add * sigma_heading_ * random_.normal();
  Estimate e;
  e.time_s = time_s;
  e.room = room;
  e.pose = {pose.position + error_, wrap_angle(pose.heading + heading_error_)};
  e.sigma_m = sigma_m_;
  e.sigma_heading_rad = sigma_heading_;
  e.room_probability = 0.97;
  e.state = TrackState::tracking;
  e.speed_mps = speed;
  estimate_ = e;
  guide.on_estimate(e);
}

Spot random_spot(const Router& router, Random& random) {
  const Building& b = router.building();
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const auto room = static_cast<RoomIndex>(random.uniform(0.0, static_cast<double>(b.rooms.size())));
    const auto [low, high] = box_about(b.room(room).walls);
    const Vec2 p{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    if (router.space(room).contains(p) && router.space(room).clearance(p, 0.5) >= 0.5) return {room, p};
  }
  return {};
}

WalkOutcome walk_blindfolded(const Router& router, const Spot& start, double heading, const Goal& goal,
                             PoseSource& source, const WearerModel& model, std::uint64_t seed,
                             std::optional<double> shortest_m) {
  WalkOutcome outcome;
  Random random(seed);
  Body body(router, start, heading, source);
  Wearer wearer(router, body, model, random, outcome);
  const Speaker speaker(router.building());
  Guide guide(router);
  const Result<Route> best = router.find_route(start, goal);
  if (!best || !guide.set_destination(goal)) return outcome;
  outcome.shortest_m = shortest_m.value_or(walked_length(*best));
  // Nobody gives up soon: five minutes, and as long again as a slow walker would need five times over.
  const double limit = 300.0 + 5.0 * outcome.shortest_m / model.speed_low;
  double last_trace = -1.0;
  for (double now = 0.0; now < limit && !wearer.done(); now += kTick) {
    wearer.live(now);
    if (wearer.away()) {
      source.observe_between(now, wearer.crossing(), guide);
    } else {
      source.observe(now, body.room(), body.pose(), wearer.speed(), guide);
    }
    if (wearer.asks()) guide.repeat();
    if (source.heed(guide)) outcome.doubts.push_back(now);
    Cue cue;
    while (guide.next_cue(cue)) {
      outcome.words.push_back(speaker.say(cue));
      wearer.hear(cue, now);
    }
    if (now - last_trace >= 0.25) {
      outcome.trace.push_back({now, body.room(), body.pose()});
      last_trace = now;
    }
    outcome.time_s = now;
  }
  const auto end = router.find_route({body.room(), body.pose().position}, goal);
  outcome.end_error_m = end ? walked_length(*end) : 1e9;
  const bool in_sight = goal.kind == Goal::Kind::spot && goal.spot.room == body.room() &&
                        router.space(body.room()).clear_between(body.pose().position, goal.spot.at, 0.0);
  if (in_sight) outcome.end_error_m = distance(body.pose().position, goal.spot.at);
  constexpr double kThere = 1.5;
  outcome.arrived = wearer.done() && outcome.end_error_m <= kThere;
  return outcome;
}

}  // namespace echoway::test
