// Building folders and logs with the numbers that files should not have, and plans drawn far off or very thin.
#include <cmath>
#include <string>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/sim/walk_file.hpp"
#include "plans/plans.hpp"
#include "plans/scratch_folder.hpp"
#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

using plans::ScratchFolder;

constexpr const char* kNotNumbers[] = {"nan",    "NaN",  "-nan",  "nan(1)", "inf", "-inf", "INFINITY",
                                       "1e309",  "-1e400", "0x1p3", "1,5",   "1e",  "--1",  "1.2.3"};

std::string room_text(const std::vector<Segment>& walls) {
  std::string text = std::to_string(walls.size()) + " 0 0\n";
  for (const Segment& w : walls) {
    text += "1";
    for (const double v : {w.a.x, w.a.y, w.b.x, w.b.y}) {
      char number_text[40];
      std::snprintf(number_text, sizeof number_text, " %.17g", v);
      text += number_text;
    }
    text += "\n";
  }
  return text;
}

Result<Building> load_room(const std::vector<Segment>& walls) {
  const ScratchFolder folder("stiff-plans");
  folder.write("room-a.room", room_text(walls));
  folder.write("building.cfg", "units m\nroom a level 0\n");
  return load_building(folder.path());
}

std::vector<Segment> walls_of(const std::vector<Vec2>& loop) { return plans::polygon_room("a", loop).walls; }

/// The room loads, its floor has the area it should have, and a point is on it.
Outcome loads(const std::vector<Segment>& walls, double area, double bound, Vec2 inside) {
  const Result<Building> building = load_room(walls);
  if (!building) return holds("loads", false, building.error().message);
  double got = 0.0;
  for (const auto& loop : building->rooms[0].boundary) got += signed_area(loop);
  if (!contains(building->rooms[0].boundary, inside)) return holds("its middle is inside", false, "outside");
  return within(area, got, Unit::relative, bound);
}

Outcome refused(const std::vector<Segment>& walls) {
  const Result<Building> building = load_room(walls);
  return holds("refused with a reason", !building && !building.error().message.empty(),
               building ? "loaded" : building.error().message);
}

void add_shapes(std::vector<Case>& table) {
  const std::vector<Vec2> box{{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}};
  const auto add = [&](std::string name, std::function<Outcome()> run) {
    table.push_back({"Plans from files", std::move(name), std::move(run)});
  };
  const auto with = [=](std::vector<Segment> extra) {
    std::vector<Segment> walls = walls_of(box);
    walls.insert(walls.end(), extra.begin(), extra.end());
    return walls;
  };
  add("a comb of 500 walls", [] {
    return loads(walls_of(plans::comb_room("a", 500).boundary[0]), 249.0 * 2.0 + 125.0 * 3.0, 1e-12, {0.5, 4.0});
  });
  add("a sliver of 0.1 x 200 m", [] {
    return loads(walls_of({{0.0, 0.0}, {200.0, 0.0}, {200.0, 0.1}, {0.0, 0.1}}), 20.0, 1e-12, {100.0, 0.05});
  });
  add("a sliver at 17 degrees", [] {
    std::vector<Vec2> loop{{0.0, 0.0}, {200.0, 0.0}, {200.0, 0.1}, {0.0, 0.1}};
    const plans::Motion turn{false, degrees(17.0), {}};
    for (Vec2& p : loop) p = turn.apply(p);
    return loads(walls_of(loop), 20.0, 1e-11, turn.apply({100.0, 0.05}));
  });
  add("a room 1e6 m off the origin", [=] {
    std::vector<Vec2> loop = box;
    for (Vec2& p : loop) p = p + Vec2{1e6, -1e6};
    return loads(walls_of(loop), 20.0, 1e-9, {1e6 + 2.0, -1e6 + 2.0});
  });
  add("a wall of zero length besides",
      [=] { return loads(with({{{2.0, 0.0}, {2.0, 0.0}}}), 20.0, 1e-12, {2.0, 2.0}); });
  add("a wall of 1e-12 m besides", [=] { return loads(with({{{2.0, 0.0}, {2.0, 1e-12}}}), 20.0, 1e-9, {2.0, 2.0}); });
  add("a wall drawn twice", [=] { return loads(with({{{5.0, 0.0}, {0.0, 0.0}}}), 20.0, 1e-12, {2.0, 2.0}); });
  add("walls that miss each other by 1e-9 m", [] {
    return loads({{{0.0, 0.0}, {5.0 - 1e-9, 0.0}},
                  {{5.0, 1e-9}, {5.0, 4.0}},
                  {{5.0, 4.0}, {0.0, 4.0}},
                  {{0.0, 4.0}, {0.0, 0.0}}},
                 20.0, 1e-8, {2.0, 2.0});
  });
  add("walls that miss each other by 1 m", [] {
    return refused(
        {{{0.0, 0.0}, {4.0, 0.0}}, {{5.0, 0.0}, {5.0, 4.0}}, {{5.0, 4.0}, {0.0, 4.0}}, {{0.0, 4.0}, {0.0, 0.0}}});
  });
  add("only walls of zero length", [] { return refused({{{1.0, 1.0}, {1.0, 1.0}}, {{2.0, 2.0}, {2.0, 2.0}}}); });
  add("a floor without area", [] {
    return refused({{{0.0, 0.0}, {5.0, 0.0}}, {{5.0, 0.0}, {0.0, 0.0}}});
  });
  add("walls 1e300 m long", [] { return refused(walls_of({{0.0, 0.0}, {1e300, 0.0}, {1e300, 1e300}, {0.0, 1e300}})); });
}

/// Puts every non-number into every field of `line` (its fields at `numeric`), one at a time, and counts what is taken.
template <class Accepts>
int accepted(const std::vector<std::string>& fields, const std::vector<std::size_t>& numeric, char separator,
             Accepts accepts) {
  int taken = 0;
  for (const std::size_t at : numeric) {
    for (const char* bad : kNotNumbers) {
      std::string line;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) line += separator;
        line += i == at ? bad : fields[i];
      }
      taken += accepts(line + "\n");
    }
  }
  return taken;
}

Outcome none_accepted(int taken) {
  return worst("every one refused with its line", taken, Unit::absolute, 0.0, std::to_string(taken) + " taken");
}

bool named_line(const Error& error) { return error.line > 0 && !error.message.empty(); }

void add_not_numbers(std::vector<Case>& table) {
  struct Line {
    const char* name;
    std::vector<std::string> fields;
    std::vector<std::size_t> numeric;
  };
  static const char* const kRoom = "4 0 0\n1 0 0 5 0\n1 5 0 5 4\n1 5 4 0 4\n1 0 4 0 0\n";
  for (const Line& line : {Line{"wall", {"1", "0", "0", "1", "1"}, {1, 2, 3, 4}},
                           Line{"corner", {"2", "0", "0"}, {1, 2}}, Line{"edge", {"3", "1", "1"}, {1, 2}},
                           Line{"all-reflective element", {"4", "1", "1", "2", "2"}, {1, 2, 3, 4}}}) {
    table.push_back({"NaN and infinity", std::string("in every number of a room's ") + line.name, [=] {
                       return none_accepted(accepted(line.fields, line.numeric, ' ', [&](const std::string& text) {
                         const ScratchFolder folder("stiff-nan");
                         const bool is_wall = line.fields[0] == "1";
                         const std::string counts = is_wall                   ? "5 0 0"
                                                    : line.fields[0] == "2" ? "4 1 0"
                                                    : line.fields[0] == "3" ? "4 0 1"
                                                                            : "4 0 0 1";
                         folder.write("room-a.room", counts + std::string(kRoom).substr(5) + text);
                         folder.write("building.cfg", "units m\nroom a level 0\n");
                         const Result<Building> b = load_building(folder.path());
                         return b.ok() || !named_line(b.error());
                       }));
                     }});
  }
  for (const Line& line :
       {Line{"R x y S x y", {"a", "5", "2", "b", "0", "2"}, {1, 2, 4, 5}},
        Line{"door", {"door", "a", "5", "2", "b", "0", "2", "width", "1"}, {2, 3, 5, 6, 8}},
        Line{"room", {"room", "a", "level", "0"}, {3}}, Line{"frame", {"frame", "a", "0", "0", "90"}, {2, 3, 4}},
        Line{"stairs", {"stairs", "a", "1", "1", "b", "1", "1"}, {2, 3, 5, 6}},
        Line{"elevator", {"elevator", "a", "1", "1", "b", "1", "1"}, {2, 3, 5, 6}},
        Line{"exit", {"exit", "a", "0", "1", "\"out\""}, {2, 3}},
        Line{"place", {"place", "a", "1", "1", "\"desk\""}, {2, 3}}}) {
    table.push_back({"NaN and infinity", std::string("in every number of the line `") + line.name + "`", [=] {
                       return none_accepted(accepted(line.fields, line.numeric, ' ', [&](const std::string& text) {
                         const ScratchFolder folder("stiff-nan");
                         folder.write("room-a.room", kRoom);
                         folder.write("room-b.room", kRoom);
                         folder.write("building.cfg", "units m\n" + text);
                         const Result<Building> b = load_building(folder.path());
                         return b.ok() || !named_line(b.error());
                       }));
                     }});
  }
  const auto add_log = [&](const char* name, const char* header, Line line, auto reads) {
    table.push_back({"NaN and infinity", std::string("in every number of a ") + name, [=] {
                       return none_accepted(accepted(line.fields, line.numeric, ',', [&](const std::string& text) {
                         const ScratchFolder folder("stiff-nan");
                         folder.write("log.csv", std::string(header) + "\n" + text);
                         const auto log = reads(folder.path() / "log.csv");
                         return log.ok() || !named_line(log.error());
                       }));
                     }});
  };
  add_log("scan log", "time_s,sensor,range_m", {"", {"1.5", "3", "2.25"}, {0, 1, 2}},
          [](const std::filesystem::path& file) { return read_scan_log(file); });
  add_log("motion log", "time_s,kind,value", {"", {"1.5", "yaw_rate_dps", "2.25"}, {0, 2}}, read_motion_log);
  add_log("truth log", "time_s,room,x_m,y_m,heading_deg", {"", {"1.5", "a", "1", "2", "90"}, {0, 2, 3, 4}},
          read_truth_log);
  add_log("track", "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state",
          {"", {"1.5", "a", "1", "2", "90", "0.1", "0.9", "tracking"}, {0, 2, 3, 4, 5, 6}}, read_track_log);
}

/// Every statement of a walk file that has a number.
void add_walk_statements(std::vector<Case>& table) {
  struct Statement {
    std::vector<std::string> fields;
    std::vector<std::size_t> numeric;
    bool before_start = false;
  };
  static const std::vector<Statement> kStatements{
      {{"seed", "1"}, {1}, true},           {{"world", "people_per_100m2", "1"}, {2}, true},
      {{"belt", "sensors", "15"}, {2}, true}, {{"belt", "radius_m", "0.1"}, {2}, true},
      {{"belt", "beam_deg", "15"}, {2}, true}, {{"belt", "slot_s", "0.1"}, {2}, true},
      {{"start", "a", "1", "1", "0"}, {2, 3, 4}, true},
      {{"to", "a", "1", "1"}, {2, 3}},      {{"speed", "0.5"}, {1}},
      {{"pause", "1"}, {1}},                {{"turn", "90"}, {1}},
      {{"face", "90"}, {1}},                {{"teleport", "a", "1", "1", "0"}, {2, 3, 4}},
      {{"cover", "all", "5"}, {2}},         {{"stuck", "3", "1"}, {2}},
  };
  table.push_back({"NaN and infinity", "in every number of a walk file", [] {
                     int taken = 0;
                     for (const Statement& s : kStatements) {
                       taken += accepted(s.fields, s.numeric, ' ', [&](const std::string& line) {
                         const std::string start = s.fields[0] == "start" ? "" : "start a 1 1 90\n";
                         const auto walk = sim::parse_walk(
                             s.before_start ? line + start + "pause 1\n" : start + line + "pause 1\n", "walk");
                         return walk.ok() || !named_line(walk.error());
                       });
                     }
                     return none_accepted(taken);
                   }});
}

/// The same plan written in metres and in feet, read back: the largest distance between any two of its points.
Outcome units_agree() {
  Building building = plans::three_rooms();
  const ScratchFolder metres("stiff-metres");
  const ScratchFolder feet_folder("stiff-feet");
  building.unit = LengthUnit::metres;
  const Status wrote_metres = write_building(building, metres.path());
  building.unit = LengthUnit::feet;
  const Status wrote_feet = write_building(building, feet_folder.path());
  const Result<Building> a = load_building(metres.path());
  const Result<Building> b = load_building(feet_folder.path());
  if (!wrote_metres || !wrote_feet || !a || !b) {
    return holds("both load", false, a ? b.error().to_string() : a.error().to_string());
  }
  double largest = 0.0;
  for (std::size_t r = 0; r < a->rooms.size(); ++r) {
    for (std::size_t w = 0; w < a->rooms[r].walls.size(); ++w) {
      largest = larger(largest, distance(a->rooms[r].walls[w].a, b->rooms[r].walls[w].a));
    }
    largest = larger(largest, distance(a->rooms[r].frame.position, b->rooms[r].frame.position));
  }
  // Files hold 0.1 mm of a metre or of a foot.
  return worst("the same plan to the files' 0.1 mm", largest, Unit::absolute, 1e-4);
}

}  // namespace

void add_plans(std::vector<Case>& table) {
  add_shapes(table);
  table.push_back({"Plans from files", "the same plan in metres and in feet", units_agree});
  add_not_numbers(table);
  add_walk_statements(table);
}

}  // namespace echoway::stiff
