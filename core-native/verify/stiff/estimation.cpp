// The tracker fed what no belt, phone or wearer should send.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "echoway/random.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"
#include "stiff/case.hpp"
#include "stiff/wearer.hpp"
#include "tracker/elementary.hpp"
#include "tracker/population.hpp"

namespace echoway::stiff {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDay = 86400.0;
constexpr double kFound = 1.0;  // metres; a wearer so near to the truth is not lost

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

const char* name(TrackState state) {
  return state == TrackState::tracking ? "tracking" : state == TrackState::lost ? "lost" : "searching";
}

/// Every promise kept and, at the end of the walk, the wearer where they are.
Outcome still_found(const Followed& f) {
  if (!f.broken.empty()) return holds("found within 1 m", false, f.broken);
  return {"found within 1 m", metres(f.error_m) + ", sigma " + metres(f.last.sigma_m) + ", " + name(f.last.state),
          Unit::absolute, f.error_m, kFound, f.error_m <= kFound};
}

/// Every promise kept and no certainty about a wrong place; being lost is allowed.
Outcome honest(const Followed& f, double allowed_share = 0.0) {
  if (!f.broken.empty()) return holds("no confident lie", false, f.broken);
  const double share = f.estimates > 0 ? static_cast<double>(f.false_certainties) / f.estimates : 0.0;
  return worst("no confident lie", share, Unit::absolute, allowed_share,
               std::to_string(f.false_certainties) + " of " + std::to_string(f.estimates) + " estimates, at last " +
                   metres(f.error_m) + " off, " + name(f.last.state));
}

/// Feeds `firings` firings made up by `make` to a session that starts in the middle of the hall.
struct MadeUp {
  std::string broken;
  Estimate last{};
};

MadeUp made_up(int firings, const std::function<Firing(int)>& make, const SessionConfig& config) {
  MadeUp result;
  auto opened = Session::open(plans::three_rooms(), config);
  if (!opened) return {opened.error().message, {}};
  for (int i = 0; i < firings; ++i) {
    (*opened)->on_firing(make(i));
    if (result.broken.empty()) result.broken = plans::broken_promise(**opened);
  }
  result.last = (*opened)->estimate();
  return result;
}

SessionConfig in_the_hall() {
  SessionConfig config;
  config.start = {0, Vec2{2.0, 2.0}, 0.0};
  return config;
}

Firing at_slot(int i, double range) { return {0.0624 * i, i % 15, range}; }

Outcome not_certain(const MadeUp& m) {
  const bool good = m.broken.empty() && m.last.state != TrackState::tracking;
  return holds("every promise kept, not tracking", good,
               m.broken.empty() ? std::string(name(m.last.state)) + ", sigma " + metres(m.last.sigma_m) : m.broken);
}

void add_made_up(std::vector<Case>& table) {
  const auto add = [&](std::string title, std::function<Outcome()> run) {
    table.push_back({"Estimation: readings", std::move(title), std::move(run)});
  };
  add("10,000 impossible readings: 0.3 m from every sensor", [] {
    return not_certain(made_up(10000, [](int i) { return at_slot(i, 0.3); }, in_the_hall()));
  });
  add("10,000 impossible readings: anything from 0.15 to 10.67 m", [] {
    Random random(9);
    return not_certain(made_up(10000, [&](int i) { return at_slot(i, random.uniform(0.15, 10.67)); }, in_the_hall()));
  });
  add("10,000 readings of 1e300 m", [] {
    return not_certain(made_up(10000, [](int i) { return at_slot(i, 1e300); }, in_the_hall()));
  });
  add("all sensors silent for an hour, start known", [] {
    return not_certain(made_up(57692, [](int i) { return at_slot(i, Firing::kNoEcho); }, in_the_hall()));
  });
  add("all sensors silent for an hour, start unknown: all weights equal", [] {
    return not_certain(made_up(57692, [](int i) { return at_slot(i, Firing::kNoEcho); }, SessionConfig{}));
  });
  add("one sensor's echo for ten minutes, fourteen silent", [] {
    const MadeUp m =
        made_up(9616, [](int i) { return at_slot(i, i % 15 == 3 ? 2.0 : Firing::kNoEcho); }, SessionConfig{});
    return not_certain(m);
  });
}

/// A walk of a minute and a half after `firings` firings made up by `make`: whatever came before, the wearer is found
/// again.
Outcome found_after(int firings, const std::function<double(int)>& range) {
  return still_found(follow(wearer(90.0), nullptr, nullptr, [&](Session& session) {
    for (int i = 0; i < firings; ++i) session.on_firing({0.0624 * (i - firings), i % 15, range(i)});
  }));
}

void add_recoveries(std::vector<Case>& table) {
  const auto add = [&](std::string title, std::function<Outcome()> run) {
    table.push_back({"Estimation: found again", std::move(title), std::move(run)});
  };
  add("a walk after 10,000 impossible readings: 0.3 m from every sensor", [] {
    return found_after(10000, [](int) { return 0.3; });
  });
  add("a walk after 3,000 impossible readings: anything from 0.15 to 10.67 m", [] {
    Random random(9);
    return found_after(3000, [&](int) { return random.uniform(0.15, 10.67); });
  });
  add("a walk after ten minutes without any echo",
      [] { return found_after(9616, [](int) { return Firing::kNoEcho; }); });
  add("a building of one room, one hypothesis", [] {
    const Building building = plans::alone(plans::l_room("only"));
    auto opened = Session::open(building, SessionConfig{});
    if (!opened) return holds("opens", false, opened.error().message);
    std::string broken;
    for (int i = 0; i < 1000; ++i) {
      (*opened)->on_firing(at_slot(i, i % 15 == 0 ? 2.0 : Firing::kNoEcho));
      if (broken.empty()) broken = plans::broken_promise(**opened);
    }
    const bool there = (*opened)->estimate().room == 0;
    return holds("every promise kept, in that room", broken.empty() && there,
                 broken.empty() ? there ? "kept" : "in no room" : broken);
  });
}

void add_starts(std::vector<Case>& table) {
  struct Place {
    const char* title;
    Vec2 at;
  };
  for (const Place& place : {Place{"a start on a wall", {5.0, 2.0}}, Place{"a start in a corner", {0.0, 0.0}},
                             Place{"a start 0.3 m outside its room", {1.2, -0.3}},
                             Place{"a start 0.99 m outside its room", {1.2, -0.99}}}) {
    table.push_back({"Estimation: starts", place.title, [=] {
                       Wearer w = wearer(45.0);
                       w.config.start.position = place.at;
                       return still_found(follow(w));
                     }});
  }
  for (const Place& place : {Place{"a start 1.01 m outside its room", {1.2, -1.01}},
                             Place{"a start 100 m outside the building", {-100.0, 40.0}},
                             Place{"a start at 1e300", {1e300, -1e300}}}) {
    table.push_back({"Estimation: starts", place.title, [=] {
                       Wearer w = wearer(1.0);
                       w.config.start.position = place.at;
                       const auto opened = Session::open(w.building, w.config);
                       return holds("refused", !opened, opened ? "opened" : "refused");
                     }});
  }
  table.push_back({"Estimation: starts", "a start with the heading turned by 1e6 times 2 pi", [] {
                     Wearer w = wearer(20.0);
                     w.config.start.heading = 1e6 * kTwoPi;
                     return still_found(follow(w));
                   }});
  table.push_back({"Estimation: starts", "a start with a heading of 1e300 rad, place in the room unknown", [] {
                     Wearer w = wearer(45.0);
                     w.config.start = {0, std::nullopt, 1e300};
                     return still_found(follow(w));
                   }});
  table.push_back({"Estimation: starts", "a start that faces the wrong way", [] {
                     Wearer w = wearer(45.0);
                     w.config.start.heading = kPi;
                     return still_found(follow(w));
                   }});
}

void add_clocks(std::vector<Case>& table) {
  const auto add = [&](std::string title, ChangeFiring firing, ChangeHint hint) {
    table.push_back(
        {"Estimation: clocks", std::move(title), [=] { return still_found(follow(wearer(45.0), firing, hint)); }});
  };
  // From the 200th firing (12.5 s) on, both clocks are elsewhere.
  const auto shifted = [](double by) {
    return std::pair<ChangeFiring, ChangeHint>{[=](Firing f, int) {
                                                 f.time_s += f.time_s > 12.5 ? by : 0.0;
                                                 return f;
                                               },
                                               [=](MotionHint h, int) {
                                                 h.time_s += h.time_s > 12.5 ? by : 0.0;
                                                 return h;
                                               }};
  };
  for (const auto& [title, by] :
       {std::pair{"both clocks jump a day ahead", kDay}, std::pair{"both clocks go back by a day", -kDay},
        std::pair{"both clocks go back by a second", -1.0}}) {
    const auto change = shifted(by);
    add(title, change.first, change.second);
  }
  add("one firing stamped a day ahead", [](Firing f, int i) {
    if (i == 200) f.time_s += kDay;
    return f;
  }, nullptr);
  add("one motion hint stamped a day ahead", nullptr, [](MotionHint h, int i) {
    if (i == 300) h.time_s += kDay;
    return h;
  });
  add("one motion hint of every kind stamped a day ahead", nullptr, [](MotionHint h, int i) {
    if (i >= 300 && i < 340) h.time_s += kDay;
    return h;
  });
  table.push_back({"Estimation: clocks", "the belt's clock stands still for the whole walk", [] {
                     return honest(follow(wearer(30.0), [](Firing f, int) {
                       f.time_s = 1.0;
                       return f;
                     }), 1.0);
                   }});
  table.push_back({"Estimation: clocks", "both clocks stand still for the whole walk", [] {
                     return honest(follow(wearer(30.0), [](Firing f, int) {
                       f.time_s = 1.0;
                       return f;
                     }, [](MotionHint h, int) {
                       h.time_s = 1.0;
                       return h;
                     }), 1.0);
                   }});
  add("both clocks stand still for five seconds", [](Firing f, int) {
    if (f.time_s > 12.5 && f.time_s < 17.5) f.time_s = 12.5;
    return f;
  }, [](MotionHint h, int) {
    if (h.time_s > 12.5 && h.time_s < 17.5) h.time_s = 12.5;
    return h;
  });
  table.push_back({"Estimation: clocks", "firings in pairs the wrong way round", [] {
                     const Wearer w = wearer(30.0);
                     return still_found(follow(w, [&](Firing, int i) {
                       const auto& all = w.walk.scans.firings;
                       const auto other = static_cast<std::size_t>(i ^ 1);
                       return all[other < all.size() ? other : static_cast<std::size_t>(i)];
                     }));
                   }});
}

void add_motion(std::vector<Case>& table) {
  table.push_back({"Estimation: motion", "a yaw rate of 2000 deg/s throughout", [] {
                     return honest(follow(wearer(30.0), nullptr, [](MotionHint h, int) {
                       if (h.kind == MotionKind::yaw_rate) h.value = degrees(2000.0);
                       return h;
                     }), 0.02);
                   }});
  table.push_back({"Estimation: motion", "a yaw rate of 1000 deg/s throughout, which a gyroscope can show", [] {
                     return honest(follow(wearer(30.0), nullptr, [](MotionHint h, int) {
                       if (h.kind == MotionKind::yaw_rate) h.value = degrees(1000.0);
                       return h;
                     }), 0.02);
                   }});
  table.push_back({"Estimation: motion", "a step every millisecond", [] {
                     const SessionConfig config = in_the_hall();
                     auto opened = Session::open(plans::three_rooms(), config);
                     if (!opened) return holds("opens", false, opened.error().message);
                     std::string broken;
                     for (int i = 0; i < 60000; ++i) {
                       (*opened)->on_motion({0.001 * i, MotionKind::step, 1.0});
                       if (i % 62 == 0) (*opened)->on_firing({0.001 * i, i / 62 % 15, 2.0});
                       if (broken.empty()) broken = plans::broken_promise(**opened);
                     }
                     const double speed = std::fabs((*opened)->estimate().speed_mps);
                     return holds("every promise kept, at most 3 m/s", broken.empty() && speed <= 3.0,
                                  broken.empty() ? number(speed) + " m/s" : broken);
                   }});
  table.push_back({"Estimation: motion", "a heading that has turned by 1e6 times 2 pi", [] {
                     return still_found(follow(wearer(30.0), nullptr, [](MotionHint h, int) {
                       if (h.kind == MotionKind::heading) h.value += 1e6 * kTwoPi;
                       return h;
                     }));
                   }});
  table.push_back({"Estimation: motion", "10,000,000 rad of turning between two firings", [] {
                     auto opened = Session::open(plans::three_rooms(), in_the_hall());
                     if (!opened) return holds("opens", false, opened.error().message);
                     std::string broken;
                     for (int i = 0; i < 1'200'000; ++i) (*opened)->on_motion({0.4 * i, MotionKind::yaw_rate, 19.9});
                     for (int i = 0; i < 100; ++i) {
                       (*opened)->on_firing({480000.0 + 0.0624 * i, i % 15, 1.5});
                       if (broken.empty()) broken = plans::broken_promise(**opened);
                     }
                     return holds("every promise kept", broken.empty(), broken.empty() ? "kept" : broken);
                   }});
}

void add_belts(std::vector<Case>& table) {
  for (const int sensors : {1, 2, 64}) {
    table.push_back({"Estimation: belts", std::to_string(sensors) + (sensors == 1 ? " sensor" : " sensors"), [=] {
                       BeltConfig belt;
                       belt.sensors = sensors;
                       const Followed f = follow(wearer(40.0, belt));
                       return sensors > 2 ? still_found(f) : honest(f, 0.05);
                     }});
  }
  table.push_back({"Estimation: belts", "the slowest beat: one firing in ten seconds", [] {
                     BeltConfig belt;
                     belt.slot_s = 10.0;
                     return honest(follow(wearer(200.0, belt)), 0.05);
                   }});
  for (const int particles : {1, 2}) {
    table.push_back(
        {"Estimation: belts", std::to_string(particles) + (particles == 1 ? " particle" : " particles"), [=] {
           const Wearer w = wearer(30.0);
           BayesOptions options;
           options.particles = particles;
           options.particles_without_gyroscope = particles;
           BayesLocator locator(w.building, w.config.belt, w.config.start, options);
           bool finite = true;
           for (const Firing& f : w.walk.scans.firings) {
             locator.on_firing(f);
             const Estimate& e = locator.estimate();
             finite = finite && is_finite(e.pose) && std::isfinite(e.sigma_m) && std::isfinite(e.covariance_xy);
           }
           return holds("finite throughout", finite, finite ? "finite" : "not finite");
         }});
  }
}

void add_weights(std::vector<Case>& table) {
  struct Weights {
    const char* title;
    double common;
    double first;
    double share;  ///< Of the first of 100 particles, afterwards.
  };
  for (const Weights& w : {Weights{"all equal", 0.3, 0.3, 0.01},
                           Weights{"all of exp(-1e5), which is 0", std::exp(-1e5), std::exp(-1e5), 0.01},
                           Weights{"all denormal but one", 5e-324, 1.0, 1.0}, Weights{"one NaN", 0.3, kNan, 0.01},
                           Weights{"all but one 0", 0.0, 1e-300, 1.0}}) {
    table.push_back({"Estimation: weights", std::string("of 100 particles, ") + w.title, [=] {
                       tracker::Population population(100);
                       for (int i = 0; i < 100; ++i) {
                         tracker::Particle p;
                         p.room = 0;
                         p.weight = i == 0 ? w.first : w.common;
                         population.push(p);
                       }
                       population.normalize();
                       double sum = 0.0;
                       for (const tracker::Particle& p : population.particles()) sum += p.weight;
                       const double off =
                           larger(std::fabs(sum - 1.0), std::fabs(population.particles()[0].weight - w.share));
                       Random random(4);
                       population.resample(100, random);
                       return worst("a sum of 1, and the first's share " + number(w.share), off, Unit::absolute, 1e-14,
                                    std::to_string(population.size()) + " after resampling");
                     }});
  }
}

/// The largest distance, in the building's frame, between what the same firings make of two buildings that are the same
/// but for `back`, which takes a place in the second to where it is in the first.
template <class Back>
Outcome same_track(const Wearer& w, const Building& other, double bound, Back back) {
  auto first = Session::open(w.building, w.config);
  auto second = Session::open(other, w.config);
  if (!first || !second) return holds("opens", false, "does not open");
  double largest = 0.0;
  for (const Firing& f : w.walk.scans.firings) {
    (*first)->on_firing(f);
    (*second)->on_firing(f);
    const Estimate& a = (*first)->estimate();
    const Estimate& b = (*second)->estimate();
    if (a.room == kNoRoom || b.room == kNoRoom) continue;
    largest = larger(largest, distance(w.building.room(a.room).frame.transform(a.pose.position),
                                       back(other.room(b.room).frame.transform(b.pose.position))));
  }
  return worst("the same track", largest, Unit::absolute, bound);
}

void add_same_tracks(std::vector<Case>& table) {
  table.push_back({"Estimation: the same building otherwise", "rooms measured in feet instead of metres", [] {
                     const Wearer w = wearer(30.0);
                     Building feet = w.building;
                     const auto there_and_back = [](double& metres) {
                       metres = metres / kMetresPerFoot * kMetresPerFoot;
                     };
                     for (Room& room : feet.rooms) {
                       for (Segment& wall : room.walls) {
                         for (Vec2* p : {&wall.a, &wall.b}) {
                           there_and_back(p->x);
                           there_and_back(p->y);
                         }
                       }
                     }
                     return same_track(w, feet, 1e-6, [](Vec2 p) { return p; });
                   }});
  table.push_back({"Estimation: the same building otherwise", "turned by 31 degrees", [] {
                     const Wearer w = wearer(30.0);
                     const plans::Motion turn{false, degrees(31.0), {3.0, -2.0}};
                     Building turned = w.building;
                     for (Room& room : turned.rooms) {
                       room.frame = {turn.apply(room.frame.position), turn.apply_heading(room.frame.heading)};
                     }
                     const Pose2 frame{turn.shift, turn.turn};
                     return same_track(w, turned, 1e-9, [=](Vec2 p) { return frame.inverse_transform(p); });
                   }});
}

/// Where the building lies: all of it, or every room in its own frame, 2^20 m (about 1e6) from the origin, where a
/// double still tells places 1e-10 m apart.
void add_far_off(std::vector<Case>& table) {
  constexpr Vec2 kFar{0x1.0p20, -0x1.0p20};
  table.push_back({"Estimation: the same building otherwise", "1e6 m off the origin", [=] {
                     const Wearer w = wearer(30.0);
                     Building far = w.building;
                     for (Room& room : far.rooms) room.frame.position = room.frame.position + kFar;
                     return same_track(w, far, 1e-8, [=](Vec2 p) { return p - kFar; });
                   }});
  table.push_back({"Estimation: the same building otherwise", "every room drawn 1e6 m off its own origin", [=] {
                     Wearer w = wearer(45.0);
                     for (Room& room : w.building.rooms) {
                       room = plans::moved(room, {false, 0.0, kFar});
                       room.frame.position = room.frame.position - kFar;
                     }
                     for (Door& door : w.building.doors) {
                       door.at_a = door.at_a + kFar;
                       door.at_b = door.at_b + kFar;
                     }
                     w.config.start.position = *w.config.start.position + kFar;
                     for (TruthRow& row : w.walk.truth) row.pose.position = row.pose.position + kFar;
                     return still_found(follow(w));
                   }});
}

/// The walk with unusable inputs between the good ones must give the very same estimate.
void add_not_numbers(std::vector<Case>& table) {
  table.push_back({"Estimation: NaN and infinity", "in every number of every input, between good ones", [] {
                     const Wearer w = wearer(20.0);
                     auto plain = Session::open(w.building, w.config);
                     auto disturbed = Session::open(w.building, w.config);
                     if (!plain || !disturbed) return holds("opens", false, "does not open");
                     Session& s = **disturbed;
                     std::string broken;
                     int differences = 0;
                     for (const Firing& f : w.walk.scans.firings) {
                       for (const double bad : {kNan, kInfinity, -kInfinity}) {
                         s.on_firing({bad, f.sensor, 1.0});
                         s.on_firing({f.time_s, f.sensor, bad});
                         for (const MotionKind kind : {MotionKind::step, MotionKind::yaw_rate, MotionKind::heading}) {
                           s.on_motion({bad, kind, 1.0});
                           s.on_motion({f.time_s, kind, bad});
                         }
                         s.on_tick(bad);
                         s.on_belt_attached(bad);
                         s.on_belt_detached(bad);
                         const std::array<std::uint8_t, 1> byte{'$'};
                         s.on_bytes(byte, bad);
                         for (const Vec2 spot : {Vec2{bad, 1.0}, Vec2{1.0, bad}}) {
                           if (s.set_destination(Goal{Goal::Kind::spot, 0, {0, spot}})) broken = "led to no place";
                         }
                         for (const Start& start : {Start{0, Vec2{bad, 1.0}, 0.0}, Start{0, Vec2{1.0, bad}, 0.0},
                                                    Start{0, Vec2{1.0, 1.0}, bad}}) {
                           if (s.restart(start)) broken = "restarted at no place";
                         }
                         if (broken.empty()) broken = plans::broken_promise(s);
                         if (broken.empty()) broken = plans::broken_guidance(s);
                       }
                       s.on_firing(f);
                       (*plain)->on_firing(f);
                       if (broken.empty()) broken = plans::broken_promise(s);
                       differences += !(s.estimate().pose == (*plain)->estimate().pose);
                     }
                     if (!broken.empty()) return holds("ignored", false, broken);
                     return worst("ignored: the same estimates as without them", differences, Unit::absolute, 0.0,
                                  std::to_string(differences) + " differ");
                   }});
  table.push_back({"Estimation: NaN and infinity", "in every number of a belt's description and of a start", [] {
                     int opened = 0;
                     for (const double bad : {kNan, kInfinity, -kInfinity}) {
                       for (double BeltConfig::* field :
                            {&BeltConfig::radius_m, &BeltConfig::beam_rad, &BeltConfig::slot_s,
                             &BeltConfig::min_range_m, &BeltConfig::max_range_m, &BeltConfig::range_noise,
                             &BeltConfig::temperature_c}) {
                         SessionConfig config;
                         config.belt.*field = bad;
                         opened += Session::open(plans::three_rooms(), config).ok();
                       }
                       SessionConfig config;
                       config.start = {0, Vec2{bad, 0.0}, 0.0};
                       opened += Session::open(plans::three_rooms(), config).ok();
                       config.start = {0, Vec2{1.0, 1.0}, bad};
                       opened += Session::open(plans::three_rooms(), config).ok();
                     }
                     return worst("refused with a reason", opened, Unit::absolute, 0.0,
                                  std::to_string(opened) + " opened");
                   }});
}

void add_elementary(std::vector<Case>& table) {
  table.push_back({"Estimation: elementary functions", "exp over [-700, 700]", [] {
                     double largest = 0.0;
                     for (int i = -70000; i <= 70000; ++i) {
                       const double x = 0.01 * i;
                       largest = larger(largest, std::fabs(tracker::fast_exp(x) / std::exp(x) - 1.0));
                     }
                     return worst("the C library's", largest, Unit::relative, 1e-14);
                   }});
  for (const double x : {-1e5, -1e300, -kInfinity, kNan}) {
    table.push_back({"Estimation: elementary functions", "exp of " + number(x),
                     [=] { return within(0.0, tracker::fast_exp(x), Unit::absolute, 0.0); }});
  }
  table.push_back({"Estimation: elementary functions", "log from 1e-307 to 1e308", [] {
                     double largest = 0.0;
                     for (int i = -70000; i <= 70800; ++i) {
                       const double x = std::exp(0.01 * i);
                       const double expected = std::log(x);
                       largest = larger(
                           largest, std::fabs(tracker::fast_log(x) - expected) / std::fmax(1.0, std::fabs(expected)));
                     }
                     return worst("the C library's", largest, Unit::relative, 1e-15);
                   }});
  table.push_back({"Estimation: elementary functions", "log of 0, a denormal, a negative number, NaN, infinity", [] {
                     bool finite = true;
                     for (const double x : {0.0, 5e-324, -1.0, kNan, kInfinity}) {
                       finite = finite && std::isfinite(tracker::fast_log(x));
                     }
                     return holds("finite", finite, finite ? "finite" : "not finite");
                   }});
  table.push_back({"Estimation: elementary functions", "sine and cosine over [-100, 100]", [] {
                     double largest = 0.0;
                     for (int i = -100000; i <= 100000; ++i) {
                       const double x = 0.001 * i;
                       const tracker::SinCos f = tracker::fast_sincos(x);
                       largest =
                           larger(largest, std::fmax(std::fabs(f.sin - std::sin(x)), std::fabs(f.cos - std::cos(x))));
                     }
                     return worst("the C library's", largest, Unit::absolute, 1e-15);
                   }});
}

}  // namespace

void add_estimation(std::vector<Case>& table) {
  add_elementary(table);
  add_made_up(table);
  add_recoveries(table);
  add_starts(table);
  add_clocks(table);
  add_motion(table);
  add_belts(table);
  add_weights(table);
  add_same_tracks(table);
  add_far_off(table);
  add_not_numbers(table);
}

}  // namespace echoway::stiff
