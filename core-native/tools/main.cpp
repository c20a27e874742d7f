#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "commands.hpp"
#include "console.hpp"

int main(int argc, char** argv) {
  using namespace echoway::tools;
  CLI::App app{"Echoway: where am I indoors, by ultrasound"};
  // Not require_subcommand(1): that says of a mistyped command only that one is required.
  app.require_subcommand(0, 1);
  int status = kDone;
  add_commands(app, status);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) {
      complain("Say what to do; `echoway --help` lists the commands");
      return kBadInput;
    }
  } catch (const CLI::ParseError& error) {
    status = app.exit(error) == 0 ? kDone : kBadInput;
  } catch (const std::exception& error) {
    complain(std::string("echoway: internal error: ") + error.what());
    return kInternalError;
  }
  return flush_output() || status != kDone ? status : kInternalError;
}
