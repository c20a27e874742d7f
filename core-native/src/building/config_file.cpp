#include "building/config_file.hpp"

#include <array>
#include <optional>
#include <system_error>

#include "building/line_parser.hpp"
#include "echoway/text/line_reader.hpp"
#include "text/utf8.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// Lines that say something which a building.cfg may have.
constexpr int kMaxLines = 200'000;
constexpr int kMaxLevel = 1000;

class ConfigParser {
 public:
  ConfigParser(ConfigSource& config, Findings& findings) : config_(config), findings_(findings) {}

  void parse(LineParser parser, int line) {
    line_ = line;
    const std::string first = parser.word("the first word");
    for (const Keyword& keyword : kKeywords) {
      if (first != keyword.word) continue;
      (this->*keyword.parse)(parser);
      return finish(parser, keyword.form);
    }
    parse_thesis_door(first, parser);
    finish(parser, "R x y S x y");
  }

  /// Lengths are converted once the unit is known, wherever its line stands.
  void convert_lengths() {
    config_.unit = unit_.value_or(LengthUnit::feet);
    const double scale = metres_per(config_.unit);
    const auto convert = [&](Vec2& p) { p = scale * p; };
    for (auto& door : config_.doors) {
      convert(door.what.a.at);
      convert(door.what.b.at);
      if (door.what.width) *door.what.width *= scale;
    }
    for (auto& link : config_.links) {
      convert(link.what.a.at);
      convert(link.what.b.at);
    }
    for (auto& frame : config_.frames) convert(frame.what.frame.position);
    for (auto& exit : config_.exits) convert(exit.what.where.at);
    for (auto& place : config_.places) convert(place.what.where.at);
  }

 private:
  struct Keyword {
    std::string_view word;
    void (ConfigParser::*parse)(LineParser&);
    std::string_view form;
  };
  static const std::array<Keyword, 9> kKeywords;

  void finish(LineParser& parser, std::string_view form) {
    parser.end();
    if (parser.problem()) {
      findings_.unusable(Kind::bad_line, config_.file, line_,
                         *parser.problem() + "; the line must be '" + std::string(form) + "'");
    }
  }

  template <class T>
  void keep(const LineParser& parser, std::vector<Located<T>>& list, T what) {
    if (!parser.problem() && parser.at_end()) list.push_back({std::move(what), line_});
  }

  std::string name(LineParser& parser) {
    std::string out = parser.quoted("the name");
    if (text::is_utf8(out)) return out;
    findings_.warn(Kind::name, config_.file, line_, "the name is not valid UTF-8; save the file as UTF-8");
    return text::to_utf8(out);
  }

  void parse_units(LineParser& parser) {
    const std::string word = parser.word("the unit");
    if (parser.problem()) return;
    if (word != "ft" && word != "m") return parser.refuse("the unit is " + shown(word) + ", not ft or m");
    const LengthUnit unit = word == "m" ? LengthUnit::metres : LengthUnit::feet;
    if (unit_ && *unit_ != unit) return parser.refuse("another line says the other unit; keep one of the two");
    unit_ = unit;
  }

  void parse_name(LineParser& parser) {
    const std::string out = name(parser);
    if (parser.problem()) return;
    if (!config_.name.empty()) {
      findings_.warn(Kind::name, config_.file, line_,
                     "the building has a name already; the last one counts, remove the others");
    }
    config_.name = out;
  }

  void parse_room(LineParser& parser) {
    RoomNameSource out;
    out.room = parser.word("the room");
    parser.keyword("level");
    const long long level = parser.integer("the level");
    if (level < -kMaxLevel || level > kMaxLevel) {
      return parser.refuse("the level is beyond " + std::to_string(kMaxLevel) + " floors");
    }
    out.level = static_cast<int>(level);
    if (!parser.at_end()) out.name = name(parser);
    keep(parser, config_.rooms, std::move(out));
  }

  void parse_frame(LineParser& parser) {
    FrameSource out;
    const PlaceSource origin = parser.place(1.0);
    const double heading = parser.number("the rotation in degrees");
    out.room = origin.room;
    out.frame = {origin.at, wrap_angle(degrees(heading))};
    keep(parser, config_.frames, std::move(out));
  }

  void parse_door(LineParser& parser) {
    DoorSource out;
    out.keyword = true;
    out.a = parser.place(1.0);
    out.b = parser.place(1.0);
    parser.keyword("width");
    out.width = parser.number("the width");
    keep(parser, config_.doors, std::move(out));
  }

  void parse_thesis_door(const std::string& room, LineParser& parser) {
    DoorSource out;
    if (parser.size() < 6) {
      return parser.refuse(shown(room) + " starts neither a door of six words nor a line with a keyword");
    }
    out.a.room = room;
    out.a.at = parser.point(1.0);
    out.b = parser.place(1.0);
    keep(parser, config_.doors, std::move(out));
  }

  void parse_link(LineParser& parser, LevelLinkKind kind) {
    LinkSource out;
    out.kind = kind;
    out.a = parser.place(1.0);
    out.b = parser.place(1.0);
    keep(parser, config_.links, std::move(out));
  }
  void parse_stairs(LineParser& parser) { parse_link(parser, LevelLinkKind::stairs); }
  void parse_elevator(LineParser& parser) { parse_link(parser, LevelLinkKind::elevator); }

  void parse_exit(LineParser& parser) {
    LandmarkSource out;
    out.where = parser.place(1.0);
    if (!parser.at_end()) out.name = name(parser);
    keep(parser, config_.exits, std::move(out));
  }

  void parse_place(LineParser& parser) {
    LandmarkSource out;
    out.where = parser.place(1.0);
    out.name = name(parser);
    keep(parser, config_.places, std::move(out));
  }

  ConfigSource& config_;
  Findings& findings_;
  std::optional<LengthUnit> unit_;
  int line_ = 0;
};

const std::array<ConfigParser::Keyword, 9> ConfigParser::kKeywords{{
    {"units", &ConfigParser::parse_units, "units ft|m"},
    {"name", &ConfigParser::parse_name, "name \"...\""},
    {"room", &ConfigParser::parse_room, "room R level L [\"name\"]"},
    {"frame", &ConfigParser::parse_frame, "frame R x y degrees"},
    {"door", &ConfigParser::parse_door, "door R x y S x y width W"},
    {"stairs", &ConfigParser::parse_stairs, "stairs R x y S x y"},
    {"elevator", &ConfigParser::parse_elevator, "elevator R x y S x y"},
    {"exit", &ConfigParser::parse_exit, "exit R x y [\"name\"]"},
    {"place", &ConfigParser::parse_place, "place R x y \"name\""},
}};

}  // namespace

ConfigSource read_config_file(const std::filesystem::path& file, Findings& findings) {
  ConfigSource config;
  config.file = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    findings.warn(Kind::no_config, config.file, 0,
                  "is missing: lengths are taken as feet and there are no doors; write one");
    return config;
  }
  if (!std::filesystem::is_regular_file(file, ignored)) {
    findings.unusable(Kind::unreadable, config.file, 0, "is not a file");
    return config;
  }
  Result<text::LineReader> opened = text::LineReader::open(file);
  if (!opened) {
    findings.unusable(opened.error());
    return config;
  }
  text::LineReader reader = std::move(opened).value();
  ConfigParser parser(config, findings);
  int lines = 0;
  while (const auto line = reader.next()) {
    auto tokens = text::split_tokens(*line);
    if (tokens && tokens->empty()) continue;
    if (++lines > kMaxLines) {
      findings.unusable(Kind::too_large, config.file, reader.line(),
                        "has more than " + std::to_string(kMaxLines) + " lines");
      break;
    }
    if (tokens) {
      parser.parse(LineParser(std::move(*tokens)), reader.line());
    } else {
      findings.unusable(Kind::bad_line, config.file, reader.line(), "a quote is not closed");
    }
  }
  if (reader.error()) findings.unusable(*reader.error());
  parser.convert_lengths();
  return config;
}

}  // namespace echoway
