#include "echoway/sim/walk_file.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "echoway/text/line_reader.hpp"
#include "script/words.hpp"

namespace echoway::sim {
namespace {

constexpr double kFarthest = 1e5;     // Metres; a place farther off is a slip of the pen.
constexpr double kLongest = 10800.0;  // Seconds.

class Parser {
 public:
  Parser(const std::string& file, std::optional<Profile> profile) : profile_(profile) {
    walk_.file = file;
    if (profile_) walk_.world = make_world(*profile_);
  }

  Status line(std::string_view text, int number) {
    line_ = number;
    Words words(text, walk_.file, number);
    if (words.empty()) return success();
    const std::string keyword = words.keyword();
    const Reader header = header_of(keyword);
    if (header != nullptr && started()) {
      return words.error("`" + keyword + "` is about the whole walk; put it before `start`");
    }
    if (Status status = header != nullptr ? (this->*header)(words) : action(keyword, words); !status.ok()) {
      return status;
    }
    return words.finish();
  }

  Result<Walk> finish() {
    if (!started()) {
      return Error{"the walk has no start; add a line `start ROOM x y heading`", walk_.file, 0};
    }
    return std::move(walk_);
  }

 private:
  [[nodiscard]] bool started() const { return !walk_.start.room.empty(); }

  using Reader = Status (Parser::*)(Words&);

  // Reads what is said about the whole walk; null for any other keyword. Later in the file such a line would be taken
  // for something that happens from there on.
  static Reader header_of(std::string_view keyword) {
    static constexpr std::array<std::pair<std::string_view, Reader>, 6> kHeaders{{{"building", &Parser::building},
                                                                                  {"seed", &Parser::seed},
                                                                                  {"units", &Parser::units},
                                                                                  {"profile", &Parser::profile},
                                                                                  {"world", &Parser::world},
                                                                                  {"belt", &Parser::belt}}};
    for (const auto& [name, reader] : kHeaders) {
      if (name == keyword) return reader;
    }
    return nullptr;
  }

  Status action(const std::string& keyword, Words& words) {
    if (keyword == "start") return start(words);
    if (!started()) {
      return words.error("`" + keyword + "` comes before `start ROOM x y heading`, or is no keyword of a walk file");
    }
    if (keyword == "to") return to(words);
    if (keyword == "pause") return one_number<Pause>(words, "seconds", 0.0, kLongest, 1.0, &Pause::seconds);
    if (keyword == "turn") return one_number<TurnBy>(words, "degrees", -36000.0, 36000.0, kDegree, &TurnBy::angle);
    if (keyword == "face") return one_number<Face>(words, "degrees", -36000.0, 36000.0, kDegree, &Face::heading);
    if (keyword == "speed") return speed(words);
    if (keyword == "teleport") return teleport(words);
    if (keyword == "cover") return cover(words);
    if (keyword == "dead") return fault(words, SensorFault::Kind::dead);
    if (keyword == "stuck") return fault(words, SensorFault::Kind::stuck);
    if (keyword == "mend") return fault(words, SensorFault::Kind::mended);
    if (keyword == "open") return door(words, true);
    if (keyword == "close") return door(words, false);
    if (keyword == "lights") return lights(words);
    return words.error("`" + keyword + "` is no keyword of a walk file");
  }

  Status building(Words& words) { return words.text("a folder", walk_.building); }

  Status seed(Words& words) { return words.seed(walk_.seed); }

  Status units(Words& words) {
    std::string unit;
    if (Status status = words.text("m or ft", unit); !status.ok()) return status;
    if (unit != "m" && unit != "ft") return words.error("units are m or ft, not `" + unit + "`");
    unit_ = unit == "ft" ? kMetresPerFoot : 1.0;
    return success();
  }

  Status profile(Words& words) {
    std::string name;
    if (Status status = words.text("empty, furnished or hard", name); !status.ok()) return status;
    const std::optional<Profile> profile = profile_of(name);
    if (!profile) return words.error("a profile is empty, furnished or hard, not `" + name + "`");
    if (world_touched_) return words.error("`profile` must come before the first `world` line, which it would undo");
    if (!profile_) walk_.world = make_world(*profile);
    return success();
  }

  Status world(Words& words) {
    std::string name;
    if (Status status = words.text("a parameter", name); !status.ok()) return status;
    const WorldParameter* parameter = find_world_parameter(name);
    if (parameter == nullptr) {
      return words.error("the world has no parameter `" + name + "`; `echoway simulate --parameters` lists them");
    }
    double value = 0.0;
    if (Status status = words.number(name, parameter->low, parameter->high, value); !status.ok()) return status;
    parameter->set(walk_.world, value);
    world_touched_ = true;
    return success();
  }

  Status belt(Words& words) {
    std::string name;
    if (Status status = words.text("sensors, radius_m, beam_deg or slot_s", name); !status.ok()) return status;
    double value = 0.0;
    const auto read = [&](double low, double high) { return words.number(name, low, high, value); };
    if (name == "sensors") {
      int sensors = 0;
      Status status = words.integer(name, 1, kMaxSensors, sensors);
      if (status.ok()) walk_.belt.sensors = sensors;
      return status;
    }
    if (name == "radius_m") {
      Status status = read(0.0, 1.0);
      if (status.ok()) walk_.belt.radius_m = value;
      return status;
    }
    if (name == "beam_deg") {
      Status status = read(1.0, 180.0);
      if (status.ok()) walk_.belt.beam_rad = degrees(value);
      return status;
    }
    if (name == "slot_s") {
      Status status = read(0.001, 10.0);
      if (status.ok()) walk_.belt.slot_s = value;
      return status;
    }
    return words.error("a belt has sensors, radius_m, beam_deg and slot_s, but no `" + name + "`");
  }

  Status start(Words& words) {
    if (started()) return words.error("the walk has started already; move with `to` or `teleport`");
    walk_.start_line = line_;
    if (Status status = place(words, walk_.start); !status.ok()) return status;
    return heading(words, walk_.start_heading);
  }

  Status to(Words& words) {
    GoTo step;
    if (Status status = place(words, step.to); !status.ok()) return status;
    return add(step);
  }

  Status teleport(Words& words) {
    Teleport step;
    if (Status status = place(words, step.to); !status.ok()) return status;
    if (Status status = heading(words, step.heading); !status.ok()) return status;
    return add(step);
  }

  Status speed(Words& words) {
    double value = 0.0;
    const char* const what = unit_ == 1.0 ? "metres a second" : "feet a second";
    if (Status status = words.number(what, 0.05 / unit_, 5.0 / unit_, value); !status.ok()) return status;
    if (walk_.steps.empty()) {
      walk_.speed_mps = value * unit_;
      return success();
    }
    return add(SetSpeed{value * unit_});
  }

  Status cover(Words& words) {
    Cover step;
    if (Status status = words.sensors(walk_.belt.sensors, step.sensors); !status.ok()) return status;
    if (Status status = words.number("seconds", 0.0, kLongest, step.seconds); !status.ok()) return status;
    return add(step);
  }

  Status fault(Words& words, SensorFault::Kind kind) {
    SensorFault step{kind, {}, 1.0};
    if (Status status = words.sensors(walk_.belt.sensors, step.sensors); !status.ok()) return status;
    if (kind == SensorFault::Kind::stuck) {
      if (Status status = words.number("range", 0.0, 100.0, step.range_m); !status.ok()) return status;
      step.range_m *= unit_;
    }
    return add(step);
  }

  Status door(Words& words, bool open) {
    SetDoor step{{}, {}, open};
    if (Status status = words.text("a room", step.room_a); !status.ok()) return status;
    if (Status status = words.text("the room behind the door", step.room_b); !status.ok()) return status;
    return add(step);
  }

  Status lights(Words& words) {
    SetLights step;
    std::string state;
    if (Status status = words.text("a room", step.room); !status.ok()) return status;
    if (Status status = words.text("on or off", state); !status.ok()) return status;
    if (state != "on" && state != "off") return words.error("lights are on or off, not `" + state + "`");
    step.on = state == "on";
    return add(step);
  }

  Status place(Words& words, Place& place) {
    if (Status status = words.text("a room", place.room); !status.ok()) return status;
    double x = 0.0;
    double y = 0.0;
    if (Status status = words.number("x", -kFarthest, kFarthest, x); !status.ok()) return status;
    if (Status status = words.number("y", -kFarthest, kFarthest, y); !status.ok()) return status;
    place.at = {x * unit_, y * unit_};
    return success();
  }

  Status heading(Words& words, double& radians) {
    double value = 0.0;
    if (Status status = words.number("heading in degrees", -36000.0, 36000.0, value); !status.ok()) return status;
    radians = wrap_angle(degrees(value));
    return success();
  }

  template <class T>
  Status one_number(Words& words, const char* what, double low, double high, double unit, double T::*field) {
    double value = 0.0;
    if (Status status = words.number(what, low, high, value); !status.ok()) return status;
    T step;
    step.*field = value * unit;
    return add(step);
  }

  template <class T>
  Status add(T step) {
    walk_.add(std::move(step), line_);
    return success();
  }

  static constexpr double kDegree = kPi / 180.0;
  std::optional<Profile> profile_;  // Instead of the one that the file names.
  Walk walk_;
  double unit_ = 1.0;
  int line_ = 0;
  bool world_touched_ = false;
};

}  // namespace

Result<Walk> parse_walk(std::string_view text, const std::string& file) {
  Parser parser(file, std::nullopt);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (Status status = parser.line(text.substr(0, end), ++number); !status.ok()) return status.error();
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return parser.finish();
}

Result<Walk> read_walk(const std::filesystem::path& file, std::optional<Profile> profile) {
  Result<text::LineReader> opened = text::LineReader::open(file);
  if (!opened) return opened.error();
  text::LineReader reader = std::move(opened).value();
  Parser parser(file.string(), profile);
  while (const std::optional<std::string_view> line = reader.next()) {
    if (Status status = parser.line(*line, reader.line()); !status) return status.error();
  }
  if (reader.error()) return *reader.error();
  return parser.finish();
}

}  // namespace echoway::sim
