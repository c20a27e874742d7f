#include <string>
#include <utility>

#include "source/osm_document.hpp"
#include "source/osm_outlines.hpp"
#include "source/osm_storeys.hpp"
#include "source/osm_tags.hpp"
#include "source/readers.hpp"
#include "source/source_error.hpp"

// OpenStreetMap with Simple Indoor Tagging: `indoor=room|area|corridor|wall|column` on ways (or multipolygons),
// `door=*` and `entrance=*` on nodes of their outlines, `level=*` (and `repeat_on=*`) on everything.
namespace echoway::import {
namespace {

constexpr double kDefaultWallThickness = 0.1;  // metres; a light partition, for indoor=wall drawn as a line
constexpr double kWidestDoor = 5.0;            // metres; a wider one was measured in something else

class Reader {
 public:
  Reader(const std::filesystem::path& path, Report& report)
      : document_(read_osm_document(path)), report_(report), storeys_(report), outlines_(document_, storeys_, report) {}
  // Its parts know one another.
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Plan read() {
    plan_.file = document_.file;
    for (const auto& [id, way] : document_.ways) read_way(id, way);
    for (const auto& [id, relation] : document_.relations) read_relation(id, relation);
    for (const auto& [id, node] : document_.nodes) read_node(id, node);
    if (storeys_.empty()) {
      throw SourceError(Error{"holds nothing with an indoor=* and a level=* tag: map the building by Simple Indoor "
                              "Tagging first", document_.file, 0});
    }
    storeys_.number_into(plan_);
    return std::move(plan_);
  }

 private:
  Source source(const char* type, OsmId id, int line) const {
    return {document_.file + ":" + std::to_string(line), std::string(type) + "/" + std::to_string(id)};
  }

  void read_way(OsmId id, const OsmWay& way) {
    const Source from = source("way", id, way.line);
    remember_building(way.tags);
    if (!is_indoor(way.tags)) return;
    if (!outlines_.only_outlines(id)) place_way(way, from);
    const std::string indoor = tag(way.tags, "indoor");
    if (indoor == "room" || indoor == "wall" || has(way.tags, "level")) {
      storeys_.put(way.nodes, storeys_.of(way.tags, from));
    }
  }

  void place_way(const OsmWay& way, const Source& from) {
    if (OsmOutlines::is_closed(way)) {
      place_area(way.tags, from, outlines_.area_of(way, from));
    } else {
      place_line(way.tags, from, outlines_.path_of(way.nodes, from));
    }
  }

  void read_relation(OsmId id, const OsmRelation& relation) {
    const Source from = source("relation", id, relation.line);
    remember_building(relation.tags);
    if (OsmOutlines::is_area(relation)) place_area(relation.tags, from, outlines_.area_of(relation, from));
  }

  void remember_building(const OsmTags& tags) {
    if (has(tags, "building") && plan_.name.empty()) plan_.name = tag(tags, "name");
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
    const std::vector<double> on = storeys_.of(tags, from);
    if (on.empty()) {
      if (!storeys_.is_unreadable(from)) report_.unresolved(from, "", {}, "has no level=*: left out");
      return;
    }
    const UnitKind kind = unit_kind(tags);
    for (const double number : on) {
      PlanLevel& into = storeys_.at(number);
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
    const std::vector<double> on = storeys_.of(tags, from);
    if (tag(tags, "indoor") == "wall") {
      const double given = metres(tag(tags, "width"));
      for (const double number : on) {
        storeys_.at(number).walls.push_back({from, {}, path, given > 0.0 ? given : kDefaultWallThickness});
      }
    } else if (tag(tags, "highway") == "steps" && on.size() == 2) {
      // Steps are drawn upwards unless they say otherwise.
      const bool down = tag(tags, "incline") == "down";
      storeys_.join(LevelLinkKind::stairs, from, on[down ? 1 : 0], path.front(), on[down ? 0 : 1], path.back());
    } else if (has(tags, "indoor") && unit_kind(tags) == UnitKind::room) {
      report_.unresolved(from, "", {}, "a room whose outline does not return to its first node: left out");
    }
  }

  void read_node(OsmId id, const OsmNode& node) {
    const Source from = source("node", id, node.line);
    const bool entrance = is_entrance(node.tags);
    std::vector<double> on = storeys_.of(node.tags, from);
    if (on.empty()) on = storeys_.of_node(id);
    // An entrance that is only drawn on the building's outline is on the ground.
    if (entrance && on.empty() && storeys_.has(0.0)) on = {0.0};
    if (is_door(node.tags)) return place_door(node, from, on, entrance);
    if (tag(node.tags, "highway") == "elevator" && on.size() > 1) {
      for (std::size_t i = 1; i < on.size(); ++i) {
        storeys_.join(LevelLinkKind::elevator, from, on[i - 1], node.at, on[i], node.at);
      }
      return;
    }
    const std::string category = category_of(node.tags);
    if (on.empty() || (category.empty() && !has(node.tags, "name"))) return;
    for (const double number : on) {
      storeys_.at(number).amenities.push_back({from, node.at, tag(node.tags, "name"), category});
    }
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
      storeys_.at(number).doors.push_back({from, {}, {node.at}, width, entrance, tag(node.tags, "name")});
    }
  }

  OsmDocument document_;
  Report& report_;
  OsmStoreys storeys_;
  OsmOutlines outlines_;
  Plan plan_;
};

}  // namespace

Plan read_osm(const std::filesystem::path& path, Report& report) { return Reader(path, report).read(); }

}  // namespace echoway::import
