#include "import_promises.hpp"

#include <algorithm>
#include <vector>

#include "building_promises.hpp"
#include "plans/scratch_folder.hpp"

namespace echoway::fuzz {
namespace {

std::string check_report(const import::Report& report) {
  const auto& items = report.items();
  const auto sound = [](const import::ReportItem& item) {
    return !item.message.empty() && (!item.at || is_finite(*item.at));
  };
  return std::all_of(items.begin(), items.end(), sound) ? "" : "the report has an item without words or place";
}

std::string check_written(const Building& building) {
  const plans::ScratchFolder folder("fuzz-imported");
  std::vector<Finding> findings;
  const Status written = import::write_imported(building, folder.path(), findings);
  if (!written) return "an imported building is unusable: " + written.error().to_string();
  const Result<Building> loaded = load_building(folder.path());
  if (!loaded) return "what was written cannot be read: " + loaded.error().to_string();
  if (loaded->rooms.size() != building.rooms.size()) return "what was written has other rooms";
  return check_building_promises(*loaded);
}

}  // namespace

std::string check_import(import::SourceFormat format, const std::filesystem::path& plan) {
  import::Report report;
  const auto imported = import::import_building(format, plan, report);
  if (std::string broken = check_report(report); !broken.empty()) return broken;
  if (!imported) {
    const Error& error = imported.error();
    return error.message.empty() || error.file.empty() ? "a refusal without words or file" : "";
  }
  return check_written(imported->building);
}

}  // namespace echoway::fuzz
