#include "session_options.hpp"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <utility>

#include "console.hpp"
#include "echoway/locate/start_check.hpp"
#include "echoway/text/number.hpp"
#include "echoway/text/tokens.hpp"
#include "option_checks.hpp"

namespace echoway::tools {
namespace {

Error bad_start(const std::string& text, const std::string& why) {
  return {fmt::format("--start {}: {}; give R,x_m,y_m,heading_deg, blank where unknown", text, why)};
}

}  // namespace

void SessionOptions::add_to(CLI::App& command) {
  command.add_option("--building", building, "Building folder")->required()->check(not_empty());
  command
      .add_option("--start", start,
                  "R,x_m,y_m,heading_deg: room R, the rest in its frame, blank where\n"
                  "unknown; without it, the wearer is looked for")
      ->check(not_empty());
  command.add_option("--method", method, "bayes: the tracker; thesis: the thesis's method")
      ->check(CLI::IsMember({"bayes", "thesis"}))
      ->capture_default_str();
  command.add_option("--sensors", sensors, "Number of sensors on the belt")->check(whole(1, kMaxSensors));
  command.add_option("--radius", radius_m, "From the wearer's axis to the transducers, metres")
      ->check(decimal(0.0, 2.0));
  command.add_option("--beam", beam_deg, "Full angle within which a plane wall answers, degrees")
      ->check(decimal(0.01, 360.0));
  command.add_flag("--avoid-stairs", avoid_stairs, "Take stairs only where nothing else leads there");
  command.add_option("--to", destination, "Guide the wearer to a place, an exit or a room; \"exit\": the nearest")
      ->check(not_empty());
  command.add_option("--language", language, "Language of the cues")
      ->check(CLI::IsMember({"en", "de", "fr"}))
      ->capture_default_str();
  command.add_option("--directions", directions, "How cues give directions")
      ->check(CLI::IsMember({"sides", "clock", "degrees"}))
      ->capture_default_str();
  command.add_option("--lengths", lengths, "How cues give lengths")
      ->check(CLI::IsMember({"feet", "metres", "steps"}))
      ->capture_default_str();
  command.add_option("--seed", seed, "Seed of the locator's random numbers")->check(whole(0))->capture_default_str();
}

BeltConfig SessionOptions::belt(const BeltHeader& header) const {
  BeltConfig belt = header.apply_to({});
  if (sensors) belt.sensors = *sensors;
  if (radius_m) belt.radius_m = *radius_m;
  if (beam_deg) belt.beam_rad = degrees(*beam_deg);
  return belt;
}

Result<SessionConfig> SessionOptions::config(const Building& building_model, const BeltHeader& header) const {
  SessionConfig config;
  config.belt = belt(header);
  config.air_c = header.temperature_c;
  config.method = method == "thesis" ? Method::thesis : Method::bayes;
  config.seed = seed;
  if (!start.empty()) {
    Result<Start> parsed = parse_start(start, building_model);
    if (!parsed) return parsed.error();
    config.start = *parsed;
  }
  return config;
}

Result<std::unique_ptr<Session>> SessionOptions::open(Building building_model, const BeltHeader& header) const {
  const Result<SessionConfig> wanted = config(building_model, header);
  if (!wanted) return wanted.error();
  Result<std::unique_ptr<Session>> session = Session::open(std::move(building_model), *wanted);
  if (!session || destination.empty()) return session;
  const Status set = (*session)->set_destination(destination, RoutePreferences{avoid_stairs});
  if (!set) return Error{fmt::format("--to {}: {}", destination, set.error().message)};
  // The wearer may not be where they say: they are followed all the same, and told so again by a cue.
  const Status way = (*session)->check_way_from_start();
  if (!way) complain(fmt::format("--to {}: {}", destination, way.error().message));
  return session;
}

SpeechStyle SessionOptions::speech_style() const {
  SpeechStyle style;
  style.language = language_of(language).value();
  if (directions == "clock") style.direction = DirectionStyle::clock;
  if (directions == "degrees") style.direction = DirectionStyle::degrees;
  if (lengths == "metres") style.length = LengthStyle::metres;
  if (lengths == "steps") style.length = LengthStyle::steps;
  return style;
}

Result<Start> parse_start(const std::string& text, const Building& building) {
  std::array<std::string_view, 4> fields;
  const std::size_t count = text::split_at_commas(text, fields);
  if (count > fields.size()) return bad_start(text, "too many fields");
  Start start;
  start.room = building.find_room(fields[0]);
  if (*start.room == kNoRoom) return bad_start(text, fmt::format("the building has no room '{}'", fields[0]));

  std::array<std::optional<double>, 3> numbers;
  for (std::size_t i = 1; i < count; ++i) {
    if (fields[i].empty()) continue;
    numbers[i - 1] = text::parse_number(fields[i]);
    if (!numbers[i - 1]) return bad_start(text, fmt::format("'{}' is not a number", fields[i]));
  }
  if (numbers[0].has_value() != numbers[1].has_value()) return bad_start(text, "x and y belong together");
  if (numbers[0]) start.position = Vec2{*numbers[0], *numbers[1]};
  if (numbers[2]) start.heading = degrees(*numbers[2]);
  if (const Status good = check_start(start, building); !good) return bad_start(text, good.error().message);
  return start;
}

}  // namespace echoway::tools
