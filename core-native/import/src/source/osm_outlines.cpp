#include "source/osm_outlines.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "echoway/geometry/inclusion.hpp"
#include "source/osm_rings.hpp"
#include "source/osm_tags.hpp"

namespace echoway::import {
namespace {

// OpenStreetMap counts up, and what JOSM has not put into it yet counts down from -1.
bool is_older(OsmId a, OsmId b) {
  const bool new_a = a < 0, new_b = b < 0;
  if (new_a != new_b) return new_b;
  return new_a ? a > b : a < b;
}

// Of several outlines, the hole is in the one that it lies in. One that lies in none is listed when the plan is
// cleaned.
void put_into(Area& area, Path hole) {
  if (hole.empty() || area.empty()) return;
  const auto around = std::find_if(area.begin(), area.end(), [&hole](const geos::Polygon2& polygon) {
    return std::any_of(hole.begin(), hole.end(), [&](Vec2 p) { return contains({&polygon.outer, 1}, p); });
  });
  (around != area.end() ? *around : area.front()).holes.push_back(std::move(hole));
}

}  // namespace

OsmOutlines::OsmOutlines(const OsmDocument& document, OsmStoreys& storeys, Report& report)
    : document_(&document), storeys_(&storeys), report_(&report) {
  for (const auto& [id, relation] : document.relations) find_what_only_outlines(relation);
}

bool OsmOutlines::is_closed(const OsmWay& way) {
  return way.nodes.size() > 3 && way.nodes.front() == way.nodes.back();
}

bool OsmOutlines::is_area(const OsmRelation& relation) {
  return tag(relation.tags, "type") == "multipolygon" && is_indoor(relation.tags);
}

// A multipolygon's ways are something else only where they "describe something in their own right". A piece cannot be
// a room, and an outline that says no more than the relation does is none besides it. What fills a hole is.
void OsmOutlines::find_what_only_outlines(const OsmRelation& relation) {
  if (!is_area(relation)) return;
  for (const OsmMember& m : relation.members) {
    const auto found = document_->ways.find(m.ref);
    if (m.type != "way" || found == document_->ways.end()) continue;
    const OsmWay& way = found->second;
    const bool only_outlines = is_closed(way) ? m.role != "inner" && says_no_more(way.tags, relation.tags)
                                              : unit_kind(way.tags) == UnitKind::room;
    if (only_outlines) only_outlines_.insert(m.ref);
  }
}

Path OsmOutlines::path_of(const std::vector<OsmId>& nodes, const Source& source) const {
  Path path;
  for (const OsmId ref : nodes) {
    const auto node = document_->nodes.find(ref);
    if (node == document_->nodes.end()) {
      report_->unresolved(source, "", {},
                          "node " + std::to_string(ref) + " is not in the file: outline used without it");
      continue;
    }
    path.push_back(node->second.at);
  }
  return path;
}

Area OsmOutlines::area_of(const OsmWay& way, const Source& source) const {
  return {{path_of({way.nodes.begin(), way.nodes.end() - 1}, source), {}}};
}

Area OsmOutlines::area_of(const OsmRelation& relation, const Source& source) {
  Area area;
  for (Path& outline : rings_of(relation, false, source)) area.push_back({std::move(outline), {}});
  for (Path& hole : rings_of(relation, true, source)) put_into(area, std::move(hole));
  return area;
}

// Each once, though it be named twice; the oldest first, in whatever order the file has them.
std::vector<OsmId> OsmOutlines::member_ways(const OsmRelation& relation, bool holes, const Source& source) const {
  std::vector<OsmId> ids;
  for (const OsmMember& m : relation.members) {
    if ((m.role == "inner") != holes) continue;
    if (m.type != "way" || document_->ways.count(m.ref) == 0) {
      report_->unresolved(source, "", {}, "member " + std::to_string(m.ref) + " is no way of the file: left out");
    } else {
      ids.push_back(m.ref);
    }
  }
  std::sort(ids.begin(), ids.end(), is_older);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<Path> OsmOutlines::rings_of(const OsmRelation& relation, bool holes, const Source& source) {
  const std::vector<OsmId> ids = member_ways(relation, holes, source);
  std::vector<std::vector<OsmId>> ways;
  for (const OsmId id : ids) ways.push_back(document_->ways.at(id).nodes);
  const OsmRings joined = join_into_rings(ways);
  if (const std::size_t left = joined.left_over.size(); left > 0) {
    const std::string way = std::to_string(ids[joined.left_over.front()]);
    const std::string others = left > 1 ? " and " + std::to_string(left - 1) + " more" : "";
    report_->unresolved(source, "", {},
                        (holes ? "a hole" : "an outline") + (" of way " + way) + others + " does not close: left out");
  }
  std::vector<Path> paths;
  for (const std::vector<OsmId>& ring : joined.rings) {
    paths.push_back(path_of(ring, source));
    storeys_->put(ring, storeys_->of(relation.tags, source));
  }
  return paths;
}

}  // namespace echoway::import
