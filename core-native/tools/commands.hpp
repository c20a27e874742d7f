#pragma once

#include <CLI/CLI.hpp>

namespace echoway::tools {

// Each command_<name>.cpp defines one of these: it adds its subcommand, whose callback sets `status` to the exit status
// (0 done, 2 bad usage or bad input).
void add_bench(CLI::App& app, int& status);
void add_check(CLI::App& app, int& status);
void add_describe(CLI::App& app, int& status);
void add_import(CLI::App& app, int& status);
void add_locate(CLI::App& app, int& status);
void add_monitor(CLI::App& app, int& status);
void add_play(CLI::App& app, int& status);
void add_score(CLI::App& app, int& status);
void add_simulate(CLI::App& app, int& status);

inline void add_commands(CLI::App& app, int& status) {
  add_bench(app, status);
  add_check(app, status);
  add_describe(app, status);
  add_import(app, status);
  add_locate(app, status);
  add_monitor(app, status);
  add_play(app, status);
  add_score(app, status);
  add_simulate(app, status);
}

}  // namespace echoway::tools
