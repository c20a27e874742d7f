// echoway_report: chapter 6 of the thesis again, as tables. `make report` draws them.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "table.hpp"

namespace {

using echoway::report::Context;
using echoway::report::Experiment;
using echoway::report::Table;

constexpr const char* kUsage =
    "usage: echoway_report --out DIR [--quick] [--threads N] [--only NAME]...\n"
    "Writes the report's tables into DIR. Every table is the same on every run, but for processor times.\n";

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string clock_time(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

int run(const Context& context, const std::vector<Experiment>& chosen) {
  std::filesystem::create_directories(context.out);
  double left = 0.0;
  for (const Experiment& experiment : chosen) left += experiment.cost;
  double done = 0.0;
  Table times("experiment,wall_s,processor_s");
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double before = elapsed();
    const double processor_before = processor_seconds();
    fmt::print("[{}/{}] {} ...", i + 1, chosen.size(), chosen[i].what);
    std::fflush(stdout);
    chosen[i].run(context);
    done += chosen[i].cost;
    left -= chosen[i].cost;
    const double wall = elapsed() - before;
    const double processor = processor_seconds() - processor_before;
    times.add(chosen[i].name, wall, processor);
    fmt::print(" {:.0f} s, processors {:.0f} s; {} elapsed, about {} left\n", wall, processor, clock_time(elapsed()),
               clock_time(elapsed() / done * left));
    std::fflush(stdout);
  }
  times.write(context.out / "times.csv");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Context context;
  context.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<Experiment> chosen;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool more = i + 1 < words.size();
    if (words[i] == "--quick") {
      context.quick = true;
    } else if (words[i] == "--out" && more) {
      context.out = words[++i];
    } else if (words[i] == "--threads" && more) {
      context.threads = std::max(1, std::atoi(words[++i].c_str()));
    } else if (words[i] == "--only" && more) {
      const std::string& name = words[++i];
      const auto all = echoway::report::experiments();
      const auto found = std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; });
      if (found == all.end()) {
        fmt::print(stderr, "echoway_report: there is no experiment {}\n", name);
        return 2;
      }
      chosen.push_back(*found);
    } else {
      fmt::print(stderr, "{}", kUsage);
      return 2;
    }
  }
  if (context.out.empty()) {
    fmt::print(stderr, "{}", kUsage);
    return 2;
  }
  const auto all = echoway::report::experiments();
  if (chosen.empty()) chosen.assign(all.begin(), all.end());
  try {
    return run(context, chosen);
  } catch (const std::exception& error) {
    fmt::print(stderr, "\nechoway_report: {}\n", error.what());
    return 1;
  }
}
