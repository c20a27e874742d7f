#include <fmt/core.h>

#include <string>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "option_checks.hpp"

namespace echoway::tools {

void add_check(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "Say what is wrong with a building folder, by file and line");
  auto dir = std::make_shared<std::string>();
  command->add_option("DIR", *dir, "Building folder")->required()->check(not_empty());
  command->callback([dir, &status] {
    for (const Finding& finding : check_building(*dir)) {
      const bool unusable = finding.severity == Finding::Severity::unusable;
      if (unusable) status = bad_input({finding.message, finding.file, finding.line});
      else fmt::print("{}\n", finding.to_string());
    }
  });
}

}  // namespace echoway::tools
