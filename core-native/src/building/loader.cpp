#include "echoway/building/loader.hpp"

#include <algorithm>

#include "building/assembly.hpp"
#include "building/findings.hpp"

namespace echoway {

Result<Building> load_building(const std::filesystem::path& dir) {
  Findings findings;
  Assembly assembly = assemble_building(dir, findings);
  if (!findings.any_unusable()) return std::move(assembly.building);
  const Finding first = std::move(findings).sorted().front();
  return Error{first.message, first.file, first.line};
}

std::vector<Finding> check_building(const std::filesystem::path& dir) {
  Findings findings;
  (void)assemble_building(dir, findings);
  return std::move(findings).sorted();
}

}  // namespace echoway
