#include "echoway/building/loader.hpp"

#include <algorithm>

#include "building/assembly.hpp"
#include "building/findings.hpp"
#include "building/lint.hpp"

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
  const Assembly assembly = assemble_building(dir, findings);
  lint_rooms(assembly, findings);
  lint_sizes(assembly, findings);
  if (!findings.any_unusable()) {
    lint_doors(assembly, findings);
    lint_levels(assembly, findings);
    lint_landmarks(assembly, findings);
  }
  return std::move(findings).sorted();
}

}  // namespace echoway
