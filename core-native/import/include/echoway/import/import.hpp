#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/import/projection.hpp"
#include "echoway/import/report.hpp"
#include "echoway/result.hpp"

namespace echoway::import {

enum class SourceFormat {
  wrld,  ///< WRLD Indoor Map Format 1.0.0: main.json and one GeoJSON a level, in a folder or a zip archive.
  imdf,  ///< Indoor Mapping Data Format (OGC 20-094): a folder or a zip archive.
  osm,   ///< OpenStreetMap XML with Simple Indoor Tagging: one .osm file.
};

struct ImportedBuilding {
  Building building;
  LonLat centre;  ///< Origin of every level's frame; x is east, y north.
};

/// Turns a venue's plan into a building. Every repair and every thing left open is added to `report`, also when the
/// import fails. Errors name file and feature; they never leave a half-made building.
Result<ImportedBuilding> import_building(SourceFormat format, const std::filesystem::path& source, Report& report);

/// Writes an imported building as a folder, with the corners, edges and door jambs that the loader derives from its
/// walls. Everything is written and checked elsewhere first: `dir` receives a building that loads, or nothing.
/// `findings` receives what the check warns of.
Status write_imported(const Building& building, const std::filesystem::path& dir, std::vector<Finding>& findings);

/// `wrld`, `imdf` or `osm`.
Result<SourceFormat> parse_source_format(std::string_view word);

}  // namespace echoway::import
