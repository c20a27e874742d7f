#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/core.h>

#include "commands.hpp"

namespace {

constexpr int kDone = 0;
constexpr int kInternalError = 1;
constexpr int kBadUsage = 2;

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Echoway: where am I indoors, by ultrasound"};
  app.require_subcommand(1);
  int status = kDone;
  echoway::tools::add_commands(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "echoway: internal error: {}\n", error.what());
    return kInternalError;
  }
  return status;
}
