#pragma once

#include <cstddef>
#include <vector>

#include "source/osm_document.hpp"

namespace echoway::import {

struct OsmRings {
  std::vector<std::vector<OsmId>> rings;  ///< Nodes, three or more; the first is not repeated at the end.
  std::vector<std::size_t> left_over;     ///< Ways that are in none, as indices, from the lowest.
};

/// Joins the ways of a multipolygon end to end, whichever way round each is drawn. A ring ends where it comes to an end
/// node again, so that two rings that touch in one stay two. In order of the first way of each.
///
/// Where more than two ways end at a node, that rule leaves open which belong together: the first of `ways` are joined
/// first.
///
/// Ends meet where they are the same node, wherever that lies, as the rule of OpenStreetMap has it
/// (https://wiki.openstreetmap.org/wiki/Relation:multipolygon). GEOS would join by place alone: what meets at a node
/// that is not in the file would not.
[[nodiscard]] OsmRings join_into_rings(const std::vector<std::vector<OsmId>>& ways);

}  // namespace echoway::import
