#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "source/geojson.hpp"
#include "source/limits.hpp"
#include "source/readers.hpp"
#include "source/source_error.hpp"
#include "source/source_tree.hpp"

// Indoor Mapping Data Format (OGC 20-094): one FeatureCollection a feature type. Units tile a level's floor, openings
// are lines across the boundary of units, occupants name units through anchors, relationships join levels.
namespace echoway::import {
namespace {

using nlohmann::json;
using LevelIndex = std::map<std::string, std::size_t>;  // level id to Plan::levels

struct UnitPlace {
  std::size_t level;
  std::size_t unit;
};

bool any_of_words(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

UnitKind unit_kind(const std::string& category) {
  const std::string_view head = std::string_view(category).substr(0, category.find('.'));
  if (any_of_words(head, {"walkway", "lobby", "footbridge", "platform", "concourse", "unspecified"})) {
    return UnitKind::open;
  }
  if (any_of_words(head, {"stairs", "steps", "escalator", "ramp", "movingwalkway"})) return UnitKind::stairs;
  if (head == "elevator") return UnitKind::elevator;
  if (any_of_words(head, {"structure", "column", "brick", "concrete", "drywall", "glass"})) return UnitKind::solid;
  if (head == "opentobelow") return UnitKind::opening;
  if (any_of_words(head,
                   {"terrace", "unenclosedarea", "road", "vegetation", "parking", "smokingarea", "fieldofplay"})) {
    return UnitKind::outdoors;
  }
  return UnitKind::room;
}

// LABELS map language tags to text. English first, then whatever comes first by tag.
std::string label_of(const json& properties, const char* key) {
  const json& labels = member(properties, key);
  if (!labels.is_object()) return text_of(properties, key);
  for (const auto& [language, text] : labels.items()) {
    if (language.substr(0, 2) == "en" && text.is_string()) return text.get<std::string>();
  }
  for (const auto& [language, text] : labels.items()) {
    if (text.is_string()) return text.get<std::string>();
  }
  return {};
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, Report& report) : tree_(path), report_(report) {}

  Plan read() {
    read_manifest();
    read_venue_name();
    read_levels();
    read_units();
    read_openings();
    read_details();
    read_occupants();
    read_amenities();
    read_relationships();
    return std::move(plan_);
  }

 private:
  // Calls `use(feature, properties, source)` for every feature of `name`.geojson; a missing file holds none.
  template <class Use>
  void for_each(const std::string& name, bool required, Use use) {
    const std::string filename = name + ".geojson";
    if (!required && !tree_.has(filename)) return;
    const std::string file = tree_.label(filename);
    const json document = parse_json(tree_.read(filename), file);
    for (const json& feature : features_of(document, file)) {
      use(feature, member(feature, "properties"), Source{file, text_of(feature, "id")});
    }
  }

  PlanLevel* level_of(const json& properties, const Source& source) {
    const std::string id = text_of(properties, "level_id");
    if (const auto found = levels_.find(id); found != levels_.end()) return &plan_.levels[found->second];
    if (outdoor_levels_.count(id) == 0) {
      report_.unresolved(source, "", {}, "stands on no level of this plan (level_id '" + id + "'): left out");
    }
    return nullptr;
  }

  void read_manifest() {
    plan_.file = tree_.label("manifest.json");
    const json manifest = parse_json(tree_.read("manifest.json"), plan_.file);
    const std::string version = text_of(manifest, "version");
    if (version.substr(0, 2) != "1.") {
      report_.note({plan_.file, ""}, "", {}, "IMDF version '" + version + "' is read as version 1.0.0");
    }
  }

  void read_venue_name() {
    for (const char* type : {"building", "venue"}) {
      for_each(type, false, [&](const json&, const json& properties, const Source&) {
        if (plan_.name.empty()) plan_.name = label_of(properties, "name");
      });
    }
  }

  void read_levels() {
    std::map<int, std::string> by_ordinal;
    for_each("level", true, [&](const json&, const json& properties, const Source& source) {
      const std::optional<int> ordinal = level_number(member(properties, "ordinal"));
      if (!ordinal) throw SourceError(source, "a level needs a whole number ordinal");
      const json& outdoor = member(properties, "outdoor");
      if (outdoor.is_boolean() && outdoor.get<bool>()) {
        outdoor_levels_.insert(source.id);
        return;
      }
      const int level = *ordinal;
      if (const auto [first, fresh] = by_ordinal.emplace(level, source.id); !fresh) {
        levels_.emplace(source.id, levels_.at(first->second));
        report_.note(source, "", {}, "shares its ordinal with level " + first->second + ": drawn on the same level");
        return;
      }
      levels_.emplace(source.id, plan_.levels.size());
      plan_.levels.push_back({});
      PlanLevel& into = plan_.levels.back();
      into.ordinal = level;
      into.name = label_of(properties, "name");
      into.short_name = label_of(properties, "short_name");
      if (into.short_name.empty()) into.short_name = std::to_string(level);
      into.file = source.file;
      into.ground = level == 0;
    });
    if (plan_.levels.empty()) throw SourceError(Error{"names no indoor level", tree_.label("level.geojson"), 0});
    sort_levels();
  }

  void sort_levels() {
    std::vector<std::size_t> order(plan_.levels.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return plan_.levels[a].ordinal < plan_.levels[b].ordinal; });
    std::vector<PlanLevel> sorted;
    std::vector<std::size_t> now(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      now[order[i]] = i;
      sorted.push_back(std::move(plan_.levels[order[i]]));
    }
    plan_.levels = std::move(sorted);
    for (auto& [id, index] : levels_) index = now[index];
  }

  void read_units() {
    for_each("unit", true, [&](const json& feature, const json& properties, const Source& source) {
      PlanLevel* level = level_of(properties, source);
      if (level == nullptr) return;
      Geometry geometry = read_geometry(feature, source);
      if (geometry.areas.empty()) {
        report_.unresolved(source, level->short_name, {}, "has no polygon: left out");
        return;
      }
      const std::string category = text_of(properties, "category");
      units_.emplace(source.id, UnitPlace{static_cast<std::size_t>(level - plan_.levels.data()), level->units.size()});
      level->units.push_back({source, unit_kind(category), std::move(geometry.areas), label_of(properties, "name"),
                              label_of(properties, "alt_name"), category, {}});
    });
  }

  void read_openings() {
    for_each("opening", false, [&](const json& feature, const json& properties, const Source& source) {
      PlanLevel* level = level_of(properties, source);
      if (level == nullptr) return;
      const std::string category = text_of(properties, "category");
      if (category == "automobile" || category == "bicycle") return;
      for (Path& path : read_geometry(feature, source).paths) {
        if (path.size() < 2) continue;
        // "principal" and "emergencyexit" are doors of the whole building, on whatever level they are.
        const bool exit = category == "emergencyexit" || category == "pedestrian.principal";
        level->doors.push_back({source, {}, {path.front(), path.back()}, 0.0, exit, label_of(properties, "name")});
      }
    });
  }

  // Details are lines of no stated meaning, fixtures and kiosks stand on the floor; fixtures may be walls.
  void read_details() {
    for (const char* type : {"fixture", "kiosk"}) {
      for_each(type, false, [&](const json& feature, const json& properties, const Source& source) {
        PlanLevel* level = level_of(properties, source);
        if (level == nullptr) return;
        Geometry geometry = read_geometry(feature, source);
        if (text_of(properties, "category") == "wall") {
          level->walls.push_back({source, std::move(geometry.areas), {}, 0.0});
        } else {
          level->furniture.push_back({source, std::move(geometry.areas), {}});
        }
      });
    }
  }

  void read_occupants() {
    struct Anchor {
      std::string unit;
      Vec2 at;
    };
    std::map<std::string, Anchor> anchors;
    for_each("anchor", false, [&](const json& feature, const json& properties, const Source& source) {
      const Geometry geometry = read_geometry(feature, source);
      if (!geometry.points.empty()) {
        anchors[source.id] = {text_of(properties, "unit_id"), geometry.points.front()};
      }
    });
    for_each("occupant", false, [&](const json&, const json& properties, const Source& source) {
      const auto anchor = anchors.find(text_of(properties, "anchor_id"));
      const auto place = anchor == anchors.end() ? units_.end() : units_.find(anchor->second.unit);
      if (place == units_.end()) {
        report_.unresolved(source, "", {}, "has no anchor in a unit: nobody can be led to it");
        return;
      }
      PlanLevel& level = plan_.levels[place->second.level];
      PlanUnit& unit = level.units[place->second.unit];
      const std::string name = label_of(properties, "name");
      if (unit.name.empty()) {
        unit.name = name;
      } else {
        level.amenities.push_back({source, anchor->second.at, name, text_of(properties, "category")});
      }
    });
  }

  void read_amenities() {
    for_each("amenity", false, [&](const json& feature, const json& properties, const Source& source) {
      const Geometry geometry = read_geometry(feature, source);
      const json& unit_ids = member(properties, "unit_ids");
      auto place = units_.end();
      if (unit_ids.is_array() && !unit_ids.empty() && unit_ids[0].is_string()) {
        place = units_.find(unit_ids[0].get<std::string>());
      }
      if (geometry.points.empty() || place == units_.end()) {
        report_.unresolved(source, "", {}, "has no point or no unit: left out");
        return;
      }
      plan_.levels[place->second.level].amenities.push_back(
          {source, geometry.points.front(), label_of(properties, "name"), text_of(properties, "category")});
    });
  }

  void read_relationships() {
    for_each("relationship", false, [&](const json&, const json& properties, const Source& source) {
      const std::string category = text_of(properties, "category");
      if (!any_of_words(category, {"elevator", "escalator", "stairs", "ramp", "movingwalkway"})) return;
      std::vector<std::string> ends{text_of(member(properties, "origin"), "id")};
      if (const json& between = member(properties, "intermediary"); between.is_array()) {
        for (const json& unit : between) ends.push_back(text_of(unit, "id"));
      }
      ends.push_back(text_of(member(properties, "destination"), "id"));
      const LevelLinkKind kind = category == "elevator" ? LevelLinkKind::elevator : LevelLinkKind::stairs;
      for (std::size_t i = 1; i < ends.size(); ++i) {
        const auto from = units_.find(ends[i - 1]), to = units_.find(ends[i]);
        if (from == units_.end() || to == units_.end()) {
          report_.unresolved(source, "", {}, "joins a unit that is not in this plan: left out");
          continue;
        }
        const int a = plan_.levels[from->second.level].ordinal, b = plan_.levels[to->second.level].ordinal;
        if (a != b) plan_.links.push_back({source, kind, {a, ends[i - 1], {}}, {b, ends[i], {}}});
      }
    });
  }

  SourceTree tree_;
  Report& report_;
  Plan plan_;
  LevelIndex levels_;
  std::set<std::string> outdoor_levels_;
  std::map<std::string, UnitPlace> units_;
};

}  // namespace

Plan read_imdf(const std::filesystem::path& path, Report& report) { return Reader(path, report).read(); }

}  // namespace echoway::import
