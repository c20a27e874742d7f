#include <algorithm>

#include "building_promises.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"
#include "folder_in_one_piece.hpp"
#include "plans/scratch_folder.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

using plans::ScratchFolder;

std::string check_round_trip(const Building& building) {
  const ScratchFolder folder("fuzz-building-out");
  if (!write_building(building, folder.path())) return "";
  const Result<Building> again = load_building(folder.path());
  if (!again) return "what was written cannot be read: " + again.error().to_string();
  const bool same = again->rooms.size() == building.rooms.size() && again->doors.size() == building.doors.size() &&
                    again->exits.size() == building.exits.size() && again->places.size() == building.places.size();
  return same ? "" : "what was written reads back as something else";
}

}  // namespace

std::string building(Bytes data) {
  const ScratchFolder folder("fuzz-building");
  unpack(data, folder);
  const Result<Building> loaded = load_building(folder.path());
  const std::vector<Finding> findings = check_building(folder.path());
  const bool unusable = std::any_of(findings.begin(), findings.end(), [](const Finding& f) {
    return f.severity == Finding::Severity::unusable;
  });
  if (loaded.ok() == unusable) return "loading and checking disagree";
  if (!loaded) return loaded.error().message.empty() ? "an error without words" : "";
  if (std::string broken = check_building_promises(*loaded); !broken.empty()) return broken;
  return check_round_trip(*loaded);
}

}  // namespace echoway::fuzz
