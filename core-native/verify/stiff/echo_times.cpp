// Echo times: right, and continuous in the pose except where another reflector takes over.
#include <cmath>
#include <limits>
#include <string>

#include "echoway/acoustics/detection.hpp"
#include "echoway/acoustics/echo_waveform.hpp"
#include "echoway/acoustics/range_model.hpp"
#include "plans/plans.hpp"
#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

RangeModel model_of(const Room& room, const BeltConfig& belt = {}) {
  return RangeModel(room, {}, belt, DetectionTable(belt));
}

std::string describe(const Pose2& pose) {
  return "(" + number(pose.position.x) + ", " + number(pose.position.y) + "), " + number(pose.heading) + " rad";
}

/// Walks the poses from `from` to `to` in `steps` and returns by how much a range outran what the step allows: the face
/// moves at most |dp| + radius |dheading|, and no path to a reflector changes by more than its face moves.
Outcome continuity(const Room& room, const Pose2& from, const Pose2& to, int steps) {
  const BeltConfig belt;
  const RangeModel model = model_of(room, belt);
  const double allowed =
      (distance(from.position, to.position) + belt.radius_m * std::fabs(to.heading - from.heading)) / steps;
  double largest = 0.0;
  int switches = 0;
  std::string where = "nowhere";
  for (int sensor = 0; sensor < belt.sensors; ++sensor) {
    PredictedEcho before;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Pose2 pose{from.position + t * (to.position - from.position),
                       from.heading + t * (to.heading - from.heading)};
      const PredictedEcho echo = model.predict(pose, sensor);
      const bool same = i > 0 && echo.kind == before.kind && echo.index == before.index;
      switches += i > 0 && !same;
      if (same && echo.has_echo()) {
        const double excess = std::fabs(echo.range_m - before.range_m) - allowed;
        if (!(excess <= largest)) where = describe(pose);
        largest = larger(largest, excess);
      }
      before = echo;
    }
  }
  return worst("no jump while one reflector wins (" + std::to_string(switches) + " times another took over)", largest,
               Unit::absolute, 1e-12, where);
}

void add_continuity(std::vector<Case>& table) {
  const auto add = [&](std::string name, Room room, Pose2 from, Pose2 to) {
    table.push_back({"Echo times", std::move(name),
                     [=, room = std::move(room)] { return continuity(room, from, to, 20000); }});
  };
  add("across an L-shaped room", plans::l_room("l"), {{0.4, 0.4}, 0.1}, {{5.5, 2.0}, 0.1});
  add("round the L's edge", plans::l_room("l"), {{3.0, 4.5}, 0.0}, {{5.0, 2.0}, 1.5});
  add("a full turn on the spot", plans::l_room("l"), {{2.0, 2.0}, 0.0}, {{2.0, 2.0}, kTwoPi});
  add("along a comb of 500 walls", plans::comb_room("comb", 500), {{0.5, 1.0}, 0.3}, {{60.0, 1.1}, 0.9});
}

/// The waveform's arrival time as distance or inclination changes a little.
Outcome arrival_continuity(bool over_distance) {
  const Transducer transducer;
  Receiver receiver;
  receiver.threshold = 0.02;
  const double period = 1.0 / (32.0 * transducer.frequency_hz);
  const int steps = 2000;
  double before = kNan;
  double largest = 0.0;
  std::string where = "nowhere";
  for (int i = 0; i <= steps; ++i) {
    const double distance_m = over_distance ? 1.0 + 0.02 * i / steps : 2.0;
    const double inclination = over_distance ? degrees(3.0) : degrees(6.0) * i / steps;
    const auto time = first_crossing(
        echo_waveform(transducer, ElementKind::wall, distance_m, inclination, period), receiver);
    if (!time) break;
    const double moved = over_distance && i > 0 ? 2.0 * 0.02 / steps / transducer.sound_speed_mps : 0.0;
    const double jump = i > 0 ? std::fabs(*time - before - moved) : 0.0;
    if (!(jump <= largest)) {
      where = over_distance ? number(distance_m) + " m" : number(to_degrees(inclination)) + " deg";
    }
    largest = larger(largest, jump);
    before = *time;
  }
  // A jump of 0.3 microseconds is 0.05 mm of range: two orders below the sensor's 1 %.
  return worst("no jump above 0.3 microseconds", largest, Unit::absolute, 3e-7, where);
}

void add_arrivals(std::vector<Case>& table) {
  table.push_back({"Echo times", "envelope's arrival while the wall recedes by 10 micrometres a step",
                   [] { return arrival_continuity(true); }});
  table.push_back({"Echo times", "envelope's arrival while the wall tilts by 0.003 degrees a step",
                   [] { return arrival_continuity(false); }});
  for (const double z : {1e-9, 0.1524, 10.668, 1e9}) {
    table.push_back({"Echo times", "echo's start at " + number(z) + " m", [=] {
                       const Transducer t;
                       const double period = 1.0 / (32.0 * t.frequency_hz);
                       const Waveform echo = echo_waveform(t, ElementKind::wall, z, 0.0, period);
                       const double from_first_cell = 0.5 * period;
                       return within(2.0 * z / t.sound_speed_mps + from_first_cell, echo.start_s, Unit::relative,
                                     4.5e-16);
                     }});
  }
}

void add_ranges(std::vector<Case>& table) {
  const BeltConfig belt;
  struct Place {
    const char* name;
    double gap;  // between face and wall
    bool heard;
  };
  for (const Place& place : {Place{"just above the shortest range", 0.1524 + 1e-9, true},
                             Place{"just below the shortest range", 0.1524 - 1e-9, false},
                             Place{"just below the longest range", 10.668 - 1e-9, true},
                             Place{"just above the longest range", 10.668 + 1e-9, false}}) {
    table.push_back({"Echo times", std::string("a wall ") + place.name, [=] {
                       const Room room = plans::box_room("wide", 60.0, 40.0);
                       const Pose2 pose{{60.0 - belt.radius_m - place.gap, 20.0}, 0.0};
                       const PredictedEcho echo = model_of(room).predict(pose, 0);
                       if (!place.heard) {
                         return holds("no echo", !echo.has_echo(), echo.has_echo() ? number(echo.range_m) : "no echo");
                       }
                       return within(place.gap, echo.range_m, Unit::absolute, 1.5e-14);
                     }});
  }
  table.push_back({"Echo times", "a sweep over 360 directions against one prediction a direction, 500 walls", [] {
                     const RangeModel model = model_of(plans::comb_room("comb", 500));
                     const Directions directions(0.05, 360);
                     std::vector<PredictedEcho> swept(360);
                     int differences = 0;
                     for (int step = 0; step < 200; ++step) {
                       const Vec2 axis{0.5 + 0.61 * step, 1.0 + 0.5 * std::sin(step)};
                       model.sweep(axis, directions, swept);
                       for (int k = 0; k < 360; ++k) {
                         const auto at = static_cast<std::size_t>(k);
                         differences += swept[at] != model.predict_towards(axis, directions.unit(k));
                       }
                     }
                     return worst("the same", differences, Unit::absolute, 0.0,
                                  std::to_string(differences) + " of 72,000 differ");
                   }});
}

void add_unusable(std::vector<Case>& table) {
  table.push_back({"Echo times", "NaN, infinity and 1e300 in every part of the pose", [] {
                     const RangeModel model = model_of(plans::l_room("l"));
                     const Directions directions(0.0, 72);
                     std::vector<PredictedEcho> swept(72);
                     int wrong = 0;
                     for (const double bad : {kNan, kInfinity, -kInfinity, 1e300, -1e300}) {
                       for (const Pose2& pose :
                            {Pose2{{bad, 1.0}, 0.0}, Pose2{{1.0, bad}, 0.0}, Pose2{{1.0, 1.0}, bad}}) {
                         for (int sensor = 0; sensor < 15; ++sensor) {
                           wrong += !std::isfinite(model.predict(pose, sensor).range_m);
                         }
                         model.sweep(pose.position, directions, swept);
                         for (const PredictedEcho& echo : swept) wrong += !std::isfinite(echo.range_m);
                       }
                     }
                     return worst("every range finite or absent", wrong, Unit::absolute, 0.0,
                                  std::to_string(wrong) + " are not");
                   }});
  for (const double beam : {1e-12, degrees(0.1), degrees(179.0), degrees(360.0), 1e9}) {
    table.push_back({"Echo times", "half-angles of a beam of " + number(beam) + " rad", [=] {
                       BeltConfig belt;
                       belt.beam_rad = beam;
                       const DetectionTable detection(belt);
                       double largest = 0.0;
                       for (int i = 0; i <= 2000; ++i) {
                         const double z = 12.0 * i / 2000.0;
                         for (const ElementKind kind : {ElementKind::wall, ElementKind::corner, ElementKind::edge}) {
                           const double half = detection.half_angle(kind, z);
                           const double excess = half > detection.widest() ? half - detection.widest() : 0.0;
                           largest = larger(largest, std::isfinite(half) ? excess : kNan);
                         }
                       }
                       const bool sensible = detection.widest() > 0.0 && detection.widest() <= 0.5 * kPi;
                       return worst("within the beam, at most 90 degrees", sensible ? largest : kNan, Unit::absolute,
                                    1e-12);
                     }});
  }
}

}  // namespace

void add_echo_times(std::vector<Case>& table) {
  add_continuity(table);
  add_arrivals(table);
  add_ranges(table);
  add_unusable(table);
}

}  // namespace echoway::stiff
