#include <fmt/core.h>

#include <string>

#include "commands.hpp"
#include "echoway/building/loader.hpp"

namespace echoway::tools {

void add_check(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "Lint a building folder: file:line: problem");
  auto dir = std::make_shared<std::string>();
  command->add_option("DIR", *dir, "Building folder")->required();
  command->callback([dir, &status] {
    for (const Finding& finding : check_building(*dir)) {
      const bool unusable = finding.severity == Finding::Severity::unusable;
      fmt::print(unusable ? stderr : stdout, "{}\n", finding.to_string());
      if (unusable) status = 2;
    }
  });
}

}  // namespace echoway::tools
