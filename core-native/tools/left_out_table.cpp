#include "left_out_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace echoway::tools {
namespace {

struct Kind {
  std::string_view head;
  std::string_view name;
  std::size_t EchoSources::*count;
};

constexpr std::array kKinds{
    Kind{"walls", "walls", &EchoSources::walls},
    Kind{"corners", "corners", &EchoSources::corners},
    Kind{"edges", "edges", &EchoSources::edges},
    Kind{"all-reflective", "all-reflective elements", &EchoSources::all_reflective},
    Kind{"by way of a wall", "corners by way of a wall", &EchoSources::mirrored_corners},
};

std::size_t width_of(const Kind& kind) { return std::max<std::size_t>(11, kind.head.size()); }

// "-" where the plan has none.
std::string share(std::size_t heard, std::size_t all) { return all == 0 ? "-" : fmt::format("{} of {}", heard, all); }

std::string head(std::size_t id_width) {
  std::string line = fmt::format("{:{}}  {:>12}", "room", id_width, "heard");
  for (const Kind& kind : kKinds) line += fmt::format("  {:>{}}", kind.head, width_of(kind));
  return line + "  kept by a place  looked at  sight tests (of)  doors ignored\n";
}

std::string row(const RoomSavings& r, const std::string& id, std::size_t id_width) {
  std::string line = fmt::format("{:{}}  {:>12}", id, id_width, share(r.heard.total(), r.within_reach.total()));
  for (const Kind& kind : kKinds) {
    line += fmt::format("  {:>{}}", share(r.heard.*kind.count, r.within_reach.*kind.count), width_of(kind));
  }
  const std::string tests =
      fmt::format("{:.1f} ({:.0f})", r.sight_tests, r.looked_at * static_cast<double>(r.sight_blockers));
  return line + fmt::format("  {:>15.1f}  {:>9.1f}  {:>16}  {:>11.0f} %\n", r.listed, r.looked_at, tests,
                            100.0 * r.plain_floor);
}

// What is never worked out in how many rooms.
std::string left_out_altogether(const SceneReport& report) {
  std::string text;
  for (const Kind& kind : kKinds) {
    const auto silent = [&](const RoomSavings& r) { return r.heard.*kind.count == 0; };
    const auto rooms = std::ranges::count_if(report.rooms, silent);
    if (rooms > 0) text += fmt::format("{} in {} of {} rooms; ", kind.name, rooms, report.rooms.size());
  }
  return text + (report.levels ? "stairs and elevators nowhere, as there are several levels"
                               : "stairs and elevators, as there is one level");
}

// What of the plan a firing would have to look at, and what it does look at: means over the rooms.
std::string savings(const SceneReport& report) {
  double reach = 0.0, looked_at = 0.0, tests = 0.0, all_tests = 0.0;
  for (const RoomSavings& r : report.rooms) {
    reach += static_cast<double>(r.within_reach.total());
    looked_at += r.looked_at;
    tests += r.sight_tests;
    all_tests += r.looked_at * static_cast<double>(r.sight_blockers);
  }
  const double rooms = std::max(1.0, static_cast<double>(report.rooms.size()));
  return fmt::format(
      "A firing looks at {:.1f} things that can echo, of {:.0f} in the room and beyond its doors and {} in the "
      "building.\n"
      "Whether something stands in between is tested {:.1f} times at most, of {:.0f}. The compiled building takes "
      "{:.2f} MB.\n",
      looked_at / rooms, reach / rooms, report.sources, tests / rooms, all_tests / rooms,
      static_cast<double>(report.bytes) / 1e6);
}

}  // namespace

std::string left_out_table(const SceneReport& report, const Building& building) {
  std::size_t id_width = std::string_view("room").size();
  for (const Room& room : building.rooms) id_width = std::max(id_width, room.id.size());
  std::string text =
      "What somebody somewhere in the room can hear, of all that the plan has there and beyond up to two open doors:\n";
  text += head(id_width);
  for (const RoomSavings& r : report.rooms) text += row(r, building.room(r.room).id, id_width);
  return text + "Left out altogether: " + left_out_altogether(report) + ".\n" + savings(report);
}

}  // namespace echoway::tools
