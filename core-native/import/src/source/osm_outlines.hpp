#pragma once

#include <set>
#include <vector>

#include "echoway/import/report.hpp"
#include "source/osm_document.hpp"
#include "source/osm_storeys.hpp"
#include "source/plan.hpp"

namespace echoway::import {

/// Ways and multipolygons as paths and areas.
class OsmOutlines {
 public:
  /// REQUIRES: all outlive this.
  OsmOutlines(const OsmDocument& document, OsmStoreys& storeys, Report& report);

  [[nodiscard]] static bool is_closed(const OsmWay& way);
  /// Whether a relation is a multipolygon that lies indoors.
  [[nodiscard]] static bool is_area(const OsmRelation& relation);
  /// Whether a way is nothing by itself, whatever it says: it outlines a multipolygon.
  [[nodiscard]] bool only_outlines(OsmId way) const { return only_outlines_.count(way) != 0; }

  /// Nodes that are not in the file are left out and reported.
  [[nodiscard]] Path path_of(const std::vector<OsmId>& nodes, const Source& source) const;
  /// REQUIRES: is_closed(way).
  [[nodiscard]] Area area_of(const OsmWay& way, const Source& source) const;
  /// What of it closes; the rest is reported. Its nodes are put on the relation's levels.
  [[nodiscard]] Area area_of(const OsmRelation& relation, const Source& source);

 private:
  void find_what_only_outlines(const OsmRelation& relation);
  [[nodiscard]] std::vector<OsmId> member_ways(const OsmRelation& relation, bool holes, const Source& source) const;
  [[nodiscard]] std::vector<Path> rings_of(const OsmRelation& relation, bool holes, const Source& source);

  const OsmDocument* document_;
  OsmStoreys* storeys_;
  Report* report_;
  std::set<OsmId> only_outlines_;
};

}  // namespace echoway::import
