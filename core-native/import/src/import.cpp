#include "echoway/import/import.hpp"

#include <new>

#include "pipeline/assemble.hpp"
#include "pipeline/project.hpp"
#include "source/limits.hpp"
#include "source/readers.hpp"
#include "source/source_error.hpp"

namespace echoway::import {
namespace {

Plan read_plan(SourceFormat format, const std::filesystem::path& source, Report& report) {
  switch (format) {
    case SourceFormat::wrld: return read_wrld(source, report);
    case SourceFormat::imdf: return read_imdf(source, report);
    case SourceFormat::osm: break;
  }
  return read_osm(source, report);
}

ImportedBuilding build(Plan& plan, Report& report) {
  const LocalProjection projection = project_plan(plan, report);
  std::vector<LevelRooms> levels;
  for (const PlanLevel& level : plan.levels) {
    levels.push_back(find_rooms(level, report));
    if (levels.back().floor.cells.empty()) {
      report.unresolved({level.file, ""}, level.short_name, {}, "the level has no room that can be entered");
    }
  }
  Building building = assemble(plan, levels, find_links(plan, levels, report), report);
  if (building.rooms.empty()) {
    throw SourceError(Error{"cannot become a building: no closed room on any level; draw rooms as areas, or walls that "
                            "meet and the doors in them", plan.file, 0});
  }
  return {std::move(building), projection.origin()};
}

}  // namespace

Result<ImportedBuilding> import_building(SourceFormat format, const std::filesystem::path& source, Report& report) {
  try {
    Plan plan = read_plan(format, source, report);
    if (plan.levels.size() > static_cast<std::size_t>(kMaxLevels)) {
      return Error{"has too many levels for a building", plan.file, 0};
    }
    return build(plan, report);
  } catch (const SourceError& error) {
    return error.error();
  } catch (const geos::GeosError& error) {
    return Error{error.what(), source.string(), 0};
  } catch (const std::bad_alloc&) {
    return Error{"needs more memory than there is", source.string(), 0};
  }
}

Result<SourceFormat> parse_source_format(std::string_view word) {
  if (word == "wrld") return SourceFormat::wrld;
  if (word == "imdf") return SourceFormat::imdf;
  if (word == "osm") return SourceFormat::osm;
  return Error{"'" + std::string(word) + "' is no plan format; take wrld, imdf or osm"};
}

}  // namespace echoway::import
