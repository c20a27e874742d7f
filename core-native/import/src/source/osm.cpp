#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "echoway/geometry/inclusion.hpp"
#include "source/limits.hpp"
#include "source/osm_document.hpp"
#include "source/osm_levels.hpp"
#include "source/osm_rings.hpp"
#include "source/readers.hpp"
#include "source/source_error.hpp"

// OpenStreetMap with Simple Indoor Tagging: `indoor=room|area|corridor|wall|column` on ways (or multipolygons),
// `door=*` and `entrance=*` on nodes of their outlines, `level=*` (and `repeat_on=*`) on everything.
namespace echoway::import {
namespace {

constexpr double kDefaultWallThickness = 0.1;  // metres; a light partition, for indoor=wall drawn as a line
constexpr double kWidestDoor = 5.0;            // metres; a wider one was measured in something else

std::string tag(const OsmTags& tags, std::string_view key) {
  const auto found = tags.find(key);
  return found == tags.end() ? std::string() : found->second;
}
bool has(const OsmTags& tags, std::string_view key) { return tags.find(key) != tags.end(); }

// Lengths are metres unless they carry a unit; others are taken as not said.
double metres(const std::string& text) {
  char* rest = nullptr;
  const double value = std::strtod(text.c_str(), &rest);
  if (rest == text.c_str() || !std::isfinite(value) || value <= 0.0) return 0.0;
  std::string unit(rest);
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  if (unit.empty() || unit == "m") return value;
  if (unit == "cm") return value * 0.01;
  return 0.0;
}

UnitKind unit_kind(const OsmTags& tags) {
  const std::string indoor = tag(tags, "indoor");
  if (tag(tags, "stairs") == "yes" || tag(tags, "room") == "stairs" || has(tags, "conveying")) return UnitKind::stairs;
  if (tag(tags, "highway") == "elevator" || tag(tags, "room") == "elevator") return UnitKind::elevator;
  if (indoor == "room") return UnitKind::room;
  return UnitKind::open;
}

std::string category_of(const OsmTags& tags) {
  for (const char* key : {"room", "amenity", "shop", "office", "tourism", "leisure", "healthcare", "emergency"}) {
    const std::string value = tag(tags, key);
    if (!value.empty() && value != "yes") return value;
  }
  return tag(tags, "indoor");
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, Report& report) : document_(read_osm_document(path)), report_(report) {}

  Plan read() {
    plan_.file = document_.file;
    for (const auto& [id, relation] : document_.relations) find_what_only_outlines(relation);
    for (const auto& [id, way] : document_.ways) read_way(id, way);
    for (const auto& [id, relation] : document_.relations) read_relation(id, relation);
    for (const auto& [id, node] : document_.nodes) read_node(id, node);
    if (levels_.empty()) {
      throw SourceError(Error{"holds nothing with an indoor=* and a level=* tag: map the building by Simple Indoor "
                              "Tagging first", document_.file, 0});
    }
    number_levels();
    return std::move(plan_);
  }

 private:
  Source source(const char* type, OsmId id, int line) const {
    return {document_.file + ":" + std::to_string(line), std::string(type) + "/" + std::to_string(id)};
  }

  // The levels that a feature stands on; none is reported once for features that need one.
  std::vector<double> levels_of(const OsmTags& tags, const Source& source) {
    if (unreadable_.count(source.id) != 0) return {};
    std::set<double> levels;
    for (const char* key : {"level", "repeat_on"}) {
      const std::string text = tag(tags, key);
      if (text.empty()) continue;
      const auto parsed = parse_osm_levels(text);
      if (!parsed) {
        report_.unresolved(source, "", {}, std::string(key) + "=" + text + " cannot be read: left out");
        unreadable_.insert(source.id);
        return {};
      }
      levels.insert(parsed->begin(), parsed->end());
    }
    return {levels.begin(), levels.end()};
  }

  PlanLevel& level(double number) { return levels_[number]; }

  Path path_of(const std::vector<OsmId>& nodes, const Source& source) {
    Path path;
    for (const OsmId ref : nodes) {
      const auto node = document_.nodes.find(ref);
      if (node == document_.nodes.end()) {
        report_.unresolved(source, "", {},
                           "node " + std::to_string(ref) + " is not in the file: outline used without it");
        continue;
      }
      path.push_back(node->second.at);
    }
    return path;
  }

  static bool closed(const OsmWay& way) { return way.nodes.size() > 3 && way.nodes.front() == way.nodes.back(); }

  // REQUIRES: the nodes of a closed way, of which the last is the first.
  Path ring_of(std::vector<OsmId> nodes, const Source& source) {
    nodes.pop_back();
    return path_of(nodes, source);
  }

  void read_way(OsmId id, const OsmWay& way) {
    const Source from = source("way", id, way.line);
    remember_building(way.tags);
    if (!is_indoor(way.tags)) return;
    if (only_outlines_.count(id) == 0) place_way(way, from);
    if (tag(way.tags, "indoor") == "room" || tag(way.tags, "indoor") == "wall" || has(way.tags, "level")) {
      put_on_levels(way.nodes, levels_of(way.tags, from));
    }
  }

  void place_way(const OsmWay& way, const Source& from) {
    if (closed(way)) {
      place_area(way.tags, from, {{ring_of(way.nodes, from), {}}});
    } else {
      place_line(way.tags, from, path_of(way.nodes, from));
    }
  }

  // So that a door there need not say on which it is.
  void put_on_levels(const std::vector<OsmId>& nodes, const std::vector<double>& levels) {
    for (const OsmId ref : nodes) node_levels_[ref].insert(levels.begin(), levels.end());
  }

  static bool is_indoor(const OsmTags& tags) {
    return has(tags, "indoor") || (has(tags, "level") && (has(tags, "highway") || has(tags, "stairs")));
  }

  void remember_building(const OsmTags& tags) {
    if (has(tags, "building") && plan_.name.empty()) plan_.name = tag(tags, "name");
  }

  // OpenStreetMap counts up, and what JOSM has not put into it yet counts down from -1.
  static bool is_older(OsmId a, OsmId b) {
    const bool new_a = a < 0, new_b = b < 0;
    if (new_a != new_b) return new_b;
    return new_a ? a > b : a < b;
  }

  static bool is_area(const OsmRelation& relation) {
    return tag(relation.tags, "type") == "multipolygon" && is_indoor(relation.tags);
  }

  // A multipolygon's ways are something else only where they "describe something in their own right". A piece cannot be
  // a room, and an outline that says no more than the relation does is none besides it. What fills a hole is.
  void find_what_only_outlines(const OsmRelation& relation) {
    if (!is_area(relation)) return;
    for (const OsmMember& m : relation.members) {
      const auto found = document_.ways.find(m.ref);
      if (m.type != "way" || found == document_.ways.end()) continue;
      const OsmWay& way = found->second;
      const bool only_outlines = closed(way) ? m.role != "inner" && says_no_more(way.tags, relation.tags)
                                             : unit_kind(way.tags) == UnitKind::room;
      if (only_outlines) only_outlines_.insert(m.ref);
    }
  }

  static bool says_no_more(const OsmTags& way, const OsmTags& relation) {
    constexpr std::array kWhatItIs{"indoor", "level", "repeat_on", "name", "ref"};
    const auto repeated = [&](const char* key) { return !has(way, key) || tag(way, key) == tag(relation, key); };
    return unit_kind(way) == unit_kind(relation) && std::all_of(kWhatItIs.begin(), kWhatItIs.end(), repeated);
  }

  void read_relation(OsmId id, const OsmRelation& relation) {
    const Source from = source("relation", id, relation.line);
    remember_building(relation.tags);
    if (!is_area(relation)) return;
    Area area;
    for (Path& outline : rings_of(relation, false, from)) area.push_back({std::move(outline), {}});
    for (Path& hole : rings_of(relation, true, from)) put_into(area, std::move(hole));
    place_area(relation.tags, from, area);
  }

  // Each once, though it be named twice; the oldest first, in whatever order the file has them.
  std::vector<OsmId> member_ways(const OsmRelation& relation, bool holes, const Source& from) {
    std::vector<OsmId> ids;
    for (const OsmMember& m : relation.members) {
      if ((m.role == "inner") != holes) continue;
      if (m.type != "way" || document_.ways.count(m.ref) == 0) {
        report_.unresolved(from, "", {}, "member " + std::to_string(m.ref) + " is no way of the file: left out");
      } else {
        ids.push_back(m.ref);
      }
    }
    std::sort(ids.begin(), ids.end(), is_older);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

  std::vector<Path> rings_of(const OsmRelation& relation, bool holes, const Source& from) {
    const std::vector<OsmId> ids = member_ways(relation, holes, from);
    std::vector<std::vector<OsmId>> ways;
    for (const OsmId id : ids) ways.push_back(document_.ways.at(id).nodes);
    const OsmRings joined = join_into_rings(ways);
    if (const std::size_t left = joined.left_over.size(); left > 0) {
      const std::string way = std::to_string(ids[joined.left_over.front()]);
      const std::string others = left > 1 ? " and " + std::to_string(left - 1) + " more" : "";
      report_.unresolved(from, "", {},
                         (holes ? "a hole" : "an outline") + (" of way " + way) + others + " does not close: left out");
    }
    std::vector<Path> paths;
    for (const std::vector<OsmId>& ring : joined.rings) {
      paths.push_back(path_of(ring, from));
      put_on_levels(ring, levels_of(relation.tags, from));
    }
    return paths;
  }

  // Of several outlines, the hole is in the one that it lies in. One that lies in none is listed when the plan is
  // cleaned.
  static void put_into(Area& area, Path hole) {
    if (hole.empty() || area.empty()) return;
    const auto around = std::find_if(area.begin(), area.end(), [&hole](const geos::Polygon2& polygon) {
      return std::any_of(hole.begin(), hole.end(), [&](Vec2 p) { return contains({&polygon.outer, 1}, p); });
    });
    (around != area.end() ? *around : area.front()).holes.push_back(std::move(hole));
  }

  void place_area(const OsmTags& tags, const Source& from, const Area& area) {
    const std::string indoor = tag(tags, "indoor");
    if (indoor == "no" || indoor == "level" || indoor == "door") return;
    if (area.empty()) {
      report_.unresolved(from, "", {}, "has no outline: left out");
      return;
    }
    if (indoor == "yes") {
      report_.unresolved(from, "", {}, "indoor=yes does not say what it is (a room, a corridor, an area): left out");
      return;
    }
    const std::vector<double> on = levels_of(tags, from);
    if (on.empty()) {
      if (unreadable_.count(from.id) == 0) report_.unresolved(from, "", {}, "has no level=*: left out");
      return;
    }
    const UnitKind kind = unit_kind(tags);
    for (const double number : on) {
      PlanLevel& into = level(number);
      if (indoor == "wall" || indoor == "column" || indoor == "pillar") {
        into.walls.push_back({from, area, {}, 0.0});
      } else if (has(tags, "furniture") || indoor == "furniture") {
        into.furniture.push_back({from, area, {}});
      } else {
        // One way over several levels is one shaft.
        const bool shaft = on.size() > 1 && (kind == UnitKind::stairs || kind == UnitKind::elevator);
        into.units.push_back({from, kind, area, tag(tags, "name"), tag(tags, "ref"), category_of(tags),
                              shaft ? from.id : std::string()});
      }
    }
  }

  void place_line(const OsmTags& tags, const Source& from, const Path& path) {
    if (path.size() < 2) return;
    const std::vector<double> on = levels_of(tags, from);
    if (tag(tags, "indoor") == "wall") {
      const double given = metres(tag(tags, "width"));
      for (const double number : on) {
        level(number).walls.push_back({from, {}, path, given > 0.0 ? given : kDefaultWallThickness});
      }
    } else if (tag(tags, "highway") == "steps" && on.size() == 2) {
      // Steps are drawn upwards unless they say otherwise.
      const bool down = tag(tags, "incline") == "down";
      steps_.push_back({from, on[down ? 1 : 0], on[down ? 0 : 1], path});
    } else if (has(tags, "indoor") && unit_kind(tags) == UnitKind::room) {
      report_.unresolved(from, "", {}, "a room whose outline does not return to its first node: left out");
    }
  }

  void read_node(OsmId id, const OsmNode& node) {
    const Source from = source("node", id, node.line);
    const bool entrance = has(node.tags, "entrance") && tag(node.tags, "entrance") != "no";
    const bool door = entrance || (has(node.tags, "door") && tag(node.tags, "door") != "no") ||
                      tag(node.tags, "indoor") == "door";
    std::vector<double> on = levels_of(node.tags, from);
    if (on.empty()) {
      if (const auto found = node_levels_.find(id); found != node_levels_.end()) {
        on.assign(found->second.begin(), found->second.end());
      }
    }
    // An entrance that is only drawn on the building's outline is on the ground.
    if (entrance && on.empty() && levels_.count(0.0) != 0) on = {0.0};
    if (door) return place_door(node, from, on, entrance);
    if (tag(node.tags, "highway") == "elevator" && on.size() > 1) {
      for (std::size_t i = 1; i < on.size(); ++i) elevators_.push_back({from, on[i - 1], on[i], {node.at, node.at}});
      return;
    }
    const std::string category = category_of(node.tags);
    if (on.empty() || (category.empty() && !has(node.tags, "name"))) return;
    for (const double number : on) level(number).amenities.push_back({from, node.at, tag(node.tags, "name"), category});
  }

  // 0 when it is not said, or in no way that can be one.
  double door_width(const OsmTags& tags, const Source& from) {
    for (const char* key : {"width", "door:width"}) {
      const std::string text = tag(tags, key);
      if (text.empty()) continue;
      const double width = metres(text);
      if (width > 0.0 && width <= kWidestDoor) return width;
      report_.unresolved(from, "", {},
                         std::string(key) + "=" + text + " is no door's width in metres: taken as not said");
    }
    return 0.0;
  }

  void place_door(const OsmNode& node, const Source& from, const std::vector<double>& on, bool entrance) {
    if (on.empty()) {
      report_.unresolved(from, "", {}, "a door without a level, on no wall: left out");
      return;
    }
    const double width = door_width(node.tags, from);
    for (const double number : on) {
      level(number).doors.push_back({from, {}, {node.at}, width, entrance, tag(node.tags, "name")});
    }
  }

  struct Steps {
    Source source;
    double from, to;
    Path path;
  };

  // Level numbers may be fractions (mezzanines); buildings count whole levels, so all are counted up from level 0.
  void number_levels() {
    bool whole = true;
    for (const auto& [number, level] : levels_) whole = whole && number == std::floor(number);
    const auto ground = std::distance(levels_.begin(), levels_.lower_bound(0.0));
    std::ptrdiff_t index = 0;
    std::map<double, int> ordinal;
    for (auto& [number, level] : levels_) {
      level.ordinal = whole ? static_cast<int>(number) : static_cast<int>(index - ground);
      level.short_name = osm_level_name(number);
      level.file = document_.file;
      level.ground = number == 0.0;
      ordinal[number] = level.ordinal;
      if (!whole) {
        report_.note({document_.file, ""}, level.short_name, {},
                     "counted as level " + std::to_string(level.ordinal) + ", for there are levels between whole ones");
      }
      plan_.levels.push_back(std::move(level));
      ++index;
    }
    const auto declare = [&](const Steps& s, LevelLinkKind kind) {
      if (ordinal.count(s.from) == 0 || ordinal.count(s.to) == 0) return;
      plan_.links.push_back(
          {s.source, kind, {ordinal[s.from], "", s.path.front()}, {ordinal[s.to], "", s.path.back()}});
    };
    for (const Steps& s : steps_) declare(s, LevelLinkKind::stairs);
    for (const Steps& s : elevators_) declare(s, LevelLinkKind::elevator);
  }

  OsmDocument document_;
  Report& report_;
  Plan plan_;
  std::map<double, PlanLevel> levels_;
  std::map<OsmId, std::set<double>> node_levels_;
  std::vector<Steps> steps_, elevators_;
  std::set<OsmId> only_outlines_;     ///< Ways that are nothing by themselves, whatever they say.
  std::set<std::string> unreadable_;  ///< Features whose level was reported once.
};

}  // namespace

Plan read_osm(const std::filesystem::path& path, Report& report) { return Reader(path, report).read(); }

}  // namespace echoway::import
