#include <algorithm>
#include <map>
#include <set>

#include "source/geojson.hpp"
#include "source/limits.hpp"
#include "source/readers.hpp"
#include "source/source_error.hpp"
#include "source/source_tree.hpp"

// WRLD Indoor Map Format 1.0.0: main.json names the levels; each level is a FeatureCollection of polygons whose
// property `type` says what they are. Everything within `building_outline` that is no wall is floor. Optional path
// files (main-paths.json and one a level) tell names and which levels stairs and elevators join.
namespace echoway::import {
namespace {

using nlohmann::json;

// Feature types that mark a piece of floor. Only `unit` stands for walls along its polygon; the others lie within walls
// that are drawn separately.
const std::map<std::string, UnitKind, std::less<>> kUnitKinds = {
    {"unit", UnitKind::room},          {"room", UnitKind::zone},
    {"bathroom", UnitKind::zone},      {"hallway", UnitKind::zone},
    {"no_geometry", UnitKind::zone},   {"stairs", UnitKind::stairs},
    {"escalator", UnitKind::stairs},   {"elevator", UnitKind::elevator},
    {"garden", UnitKind::outdoors},    {"floor_opening", UnitKind::opening},
    {"inaccessible_space", UnitKind::solid},
};

void sort_feature(const json& feature, const Source& source, PlanLevel& level, Report& report) {
  const json& properties = member(feature, "properties");
  const std::string type = text_of(properties, "type");
  Geometry geometry = read_geometry(feature, source);
  if (type == "highlight") return;
  if (geometry.areas.empty()) {
    report.unresolved(source, level.short_name, {}, "has no polygon: left out");
    return;
  }
  const std::string name = text_of(properties, "name");
  if (const auto kind = kUnitKinds.find(type); kind != kUnitKinds.end()) {
    level.units.push_back({source, kind->second, std::move(geometry.areas), name, text_of(properties, "roomnumber"),
                           type, {}});
  } else if (type == "wall" || type == "window") {
    level.walls.push_back({source, std::move(geometry.areas), {}, 0.0});
  } else if (type == "door") {
    level.doors.push_back({source, std::move(geometry.areas), {}, 0.0, false, name});
  } else if (type == "building_outline") {
    std::move(geometry.areas.begin(), geometry.areas.end(), std::back_inserter(level.outline));
  } else {
    report.unresolved(source, level.short_name, {}, "type '" + type + "' is not known in this format: left out");
  }
}

void read_level(SourceTree& tree, const std::string& filename, PlanLevel& level, Report& report) {
  level.file = tree.label(filename);
  const json document = parse_json(tree.read(filename), level.file);
  for (const json& feature : features_of(document, level.file)) {
    sort_feature(feature, {level.file, text_of(member(feature, "properties"), "id")}, level, report);
  }
}

PlanLevel* find_level(Plan& plan, int ordinal) {
  const auto found = std::find_if(plan.levels.begin(), plan.levels.end(),
                                  [ordinal](const PlanLevel& level) { return level.ordinal == ordinal; });
  return found == plan.levels.end() ? nullptr : &*found;
}

void read_level_paths(SourceTree& tree, const std::string& filename, Plan& plan, Report& report) {
  const std::string file = tree.label(filename);
  if (!tree.has(filename)) {
    report.unresolved({file, ""}, "", {}, "is named by main-paths.json but missing: its path names are not used");
    return;
  }
  const json document = parse_json(tree.read(filename), file);
  const std::optional<int> z_order = level_number(member(document, "z_order"));
  PlanLevel* level = z_order ? find_level(plan, *z_order) : nullptr;
  if (level == nullptr) {
    report.unresolved({file, ""}, "", {}, "gives no z_order of a level: its path names are not used");
    return;
  }
  for (const json& feature : features_of(document, file)) {
    const json& properties = member(feature, "properties");
    const Source source{file, text_of(properties, "id")};
    for (Path& path : read_geometry(feature, source).paths) {
      level->pathways.push_back(
          {source, std::move(path), text_of(properties, "name"), text_of(properties, "type") == "entrance"});
    }
  }
}

void read_link(const json& feature, const Source& source, Plan& plan) {
  const std::string type = text_of(member(feature, "properties"), "type");
  const json& levels = member(feature, "levels");
  const Geometry geometry = read_geometry(feature, source);
  if (!levels.is_array() || geometry.paths.empty()) return;
  const Path& path = geometry.paths.front();
  for (std::size_t i = 1; i < std::min(levels.size(), path.size()); ++i) {
    const std::optional<int> from = level_number(levels[i - 1]), to = level_number(levels[i]);
    if (!from || !to || *from == *to) continue;
    plan.links.push_back({source, type == "elevator" ? LevelLinkKind::elevator : LevelLinkKind::stairs,
                          {*from, "", path[i - 1]}, {*to, "", path[i]}});
  }
}

void read_paths(SourceTree& tree, Plan& plan, Report& report) {
  const std::string kMainPaths = "main-paths.json";
  if (!tree.has(kMainPaths)) return;
  const std::string file = tree.label(kMainPaths);
  const json document = parse_json(tree.read(kMainPaths), file);
  for (const json& feature : features_of(document, file)) {
    read_link(feature, {file, text_of(member(feature, "properties"), "id")}, plan);
  }
  const json& filenames = member(document, "level_filenames");
  if (!filenames.is_array()) return;
  for (const json& filename : filenames) {
    if (filename.is_string()) read_level_paths(tree, filename.get<std::string>(), plan, report);
  }
}

PlanLevel level_header(const json& entry, const std::string& file) {
  const std::optional<int> z_order = level_number(member(entry, "z_order"));
  const Source source{file, text_of(entry, "id")};
  if (!z_order) throw SourceError(source, "a level needs a whole number z_order");
  PlanLevel level;
  level.ordinal = *z_order;
  level.short_name = text_of(entry, "name");
  level.name = text_of(entry, "readable_name");
  if (level.short_name.empty()) level.short_name = std::to_string(level.ordinal);
  return level;
}

}  // namespace

Plan read_wrld(const std::filesystem::path& path, Report& report) {
  SourceTree tree(path);
  Plan plan;
  plan.file = tree.label("main.json");
  const json document = parse_json(tree.read("main.json"), plan.file);
  plan.name = text_of(document, "name");
  const json& levels = member(document, "levels");
  if (!levels.is_array() || levels.empty()) throw SourceError(Error{"names no levels", plan.file, 0});
  if (levels.size() > kMaxLevels) throw SourceError(Error{"names too many levels", plan.file, 0});
  std::set<int> seen;
  for (const json& entry : levels) {
    PlanLevel level = level_header(entry, plan.file);
    if (!seen.insert(level.ordinal).second) {
      throw SourceError({plan.file, text_of(entry, "id")}, "two levels have the same z_order");
    }
    read_level(tree, text_of(entry, "filename"), level, report);
    plan.levels.push_back(std::move(level));
  }
  std::sort(plan.levels.begin(), plan.levels.end(),
            [](const PlanLevel& a, const PlanLevel& b) { return a.ordinal < b.ordinal; });
  for (PlanLevel& level : plan.levels) level.ground = level.ordinal == 0;
  read_paths(tree, plan, report);
  return plan;
}

}  // namespace echoway::import
