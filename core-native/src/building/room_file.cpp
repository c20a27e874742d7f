#include "building/room_file.hpp"

#include <array>
#include <optional>

#include "building/line_parser.hpp"
#include "echoway/text/line_reader.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

constexpr std::array<std::string_view, 4> kKinds{"walls", "corners", "edges", "reflectors"};
constexpr std::string_view kLineForms =
    "write '1 x1 y1 x2 y2' (wall), '2 x y' (corner), '3 x y' (edge) or '4 x1 y1 x2 y2' (reflector)";

using Counts = std::array<long long, kKinds.size()>;

Counts parse_counts(LineParser& parser) {
  Counts counts{};
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    if (kind == 3 && parser.at_end()) break;
    counts[kind] = parser.integer("the number of " + std::string(kKinds[kind]));
    if (counts[kind] < 0) parser.refuse("the number of " + std::string(kKinds[kind]) + " is negative");
  }
  parser.end();
  return counts;
}

void parse_element(LineParser& parser, int line, double scale, RoomSource& room) {
  const std::string kind = parser.word("the kind of element");
  const bool is_segment = kind == "1" || kind == "4";
  if (!is_segment && kind != "2" && kind != "3") return parser.refuse(shown(kind) + " is no kind of element");
  const Segment segment = is_segment ? parser.segment(scale) : Segment{};
  const Vec2 point = is_segment ? Vec2{} : parser.point(scale);
  parser.end();
  if (parser.problem()) return;
  if (kind == "1") room.walls.push_back({segment, line});
  if (kind == "2") room.corners.push_back({point, line});
  if (kind == "3") room.edges.push_back({point, line});
  if (kind == "4") room.reflectors.push_back({segment, line});
}

void compare_counts(const Counts& counts, const RoomSource& room, Findings& findings) {
  const std::array<std::size_t, 4> found{room.walls.size(), room.corners.size(), room.edges.size(),
                                         room.reflectors.size()};
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    const auto said = static_cast<unsigned long long>(counts[kind]);
    if (said == found[kind]) continue;
    findings.unusable(Kind::wrong_count, room.file, room.counts_line,
                      "says " + std::to_string(said) + " " + std::string(kKinds[kind]) + " but the file has " +
                          std::to_string(found[kind]) + "; correct the count or the lines");
  }
}

}  // namespace

RoomSource read_room_file(const std::filesystem::path& file, std::string id, LengthUnit unit, Findings& findings) {
  RoomSource room;
  room.id = std::move(id);
  room.file = file.string();
  Result<text::LineReader> opened = text::LineReader::open(file);
  if (!opened) {
    findings.unusable(opened.error());
    room.readable = false;
    return room;
  }
  text::LineReader reader = std::move(opened).value();
  std::optional<Counts> counts;
  std::size_t elements = 0;
  while (const auto line = reader.next()) {
    auto tokens = text::split_tokens(*line);
    if (tokens && tokens->empty()) continue;
    LineParser parser(tokens ? std::move(*tokens) : std::vector<text::Token>{});
    if (!tokens) parser.refuse("a quote is not closed");
    const bool is_counts = !counts;
    if (is_counts) {
      counts = parse_counts(parser);
      room.counts_line = reader.line();
    } else {
      parse_element(parser, reader.line(), metres_per(unit), room);
    }
    if (parser.problem()) {
      const std::string_view form =
          is_counts ? "the first line must be 'walls corners edges [reflectors]'" : kLineForms;
      findings.unusable(Kind::bad_line, room.file, reader.line(), *parser.problem() + "; " + std::string(form));
      room.readable = false;
    }
    if (++elements > kMaxElements + 1) {
      findings.unusable(Kind::too_large, room.file, reader.line(),
                        "has more than " + std::to_string(kMaxElements) + " elements; split the room at its doors");
      room.readable = false;
      return room;
    }
  }
  if (reader.error()) {
    findings.unusable(*reader.error());
    room.readable = false;
  } else if (!counts) {
    room.readable = false;
    findings.unusable(Kind::wrong_count, room.file, 1,
                      "is empty; the first line must be 'walls corners edges [reflectors]'");
  } else if (room.readable) {
    compare_counts(*counts, room, findings);
  }
  return room;
}

}  // namespace echoway
