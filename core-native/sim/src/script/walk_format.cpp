#include <cstdio>
#include <sstream>
#include <string>

#include "echoway/sim/walk_file.hpp"

namespace echoway::sim {
namespace {

std::string number(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return buffer;
}

std::string place(const Place& place) { return place.room + " " + number(place.at.x) + " " + number(place.at.y); }

std::string list(const std::vector<int>& sensors) {
  std::string text;
  for (const int sensor : sensors) {
    if (!text.empty()) text += ',';
    text += std::to_string(sensor);
  }
  return text.empty() ? "all" : text;
}

struct Formatter {
  std::string operator()(const GoTo& step) const { return "to " + place(step.to); }
  std::string operator()(const Pause& step) const { return "pause " + number(step.seconds); }
  std::string operator()(const TurnBy& step) const { return "turn " + number(to_degrees(step.angle)); }
  std::string operator()(const Face& step) const { return "face " + number(to_degrees(step.heading)); }
  std::string operator()(const Teleport& step) const {
    return "teleport " + place(step.to) + " " + number(to_degrees(step.heading));
  }
  std::string operator()(const SetSpeed& step) const { return "speed " + number(step.mps); }
  std::string operator()(const Cover& step) const { return "cover " + list(step.sensors) + " " + number(step.seconds); }
  std::string operator()(const SensorFault& step) const {
    switch (step.kind) {
      case SensorFault::Kind::dead:
        return "dead " + list(step.sensors);
      case SensorFault::Kind::stuck:
        return "stuck " + list(step.sensors) + " " + number(step.range_m);
      case SensorFault::Kind::mended:
        break;
    }
    return "mend " + list(step.sensors);
  }
  std::string operator()(const SetDoor& step) const {
    return (step.open ? "open " : "close ") + step.room_a + " " + step.room_b;
  }
  std::string operator()(const SetLights& step) const { return "lights " + step.room + (step.on ? " on" : " off"); }
};

}  // namespace

std::string format_walk(const Walk& walk) {
  std::ostringstream out;
  if (!walk.building.empty()) out << "building " << walk.building << '\n';
  out << "seed " << walk.seed << '\n';
  const World usual;
  for (const WorldParameter& parameter : world_parameters()) {
    if (parameter.get(walk.world) == parameter.get(usual)) continue;
    out << "world " << parameter.name << ' ' << number(parameter.get(walk.world)) << '\n';
  }
  const BeltConfig belt;
  if (walk.belt.sensors != belt.sensors) out << "belt sensors " << walk.belt.sensors << '\n';
  if (walk.belt.radius_m != belt.radius_m) out << "belt radius_m " << number(walk.belt.radius_m) << '\n';
  if (walk.belt.beam_rad != belt.beam_rad) out << "belt beam_deg " << number(to_degrees(walk.belt.beam_rad)) << '\n';
  if (walk.belt.slot_s != belt.slot_s) out << "belt slot_s " << number(walk.belt.slot_s) << '\n';
  out << "start " << place(walk.start) << ' ' << number(to_degrees(walk.start_heading)) << '\n';
  out << "speed " << number(walk.speed_mps) << '\n';
  for (const WalkStep& step : walk.steps) out << std::visit(Formatter{}, step.action) << '\n';
  return out.str();
}

}  // namespace echoway::sim
