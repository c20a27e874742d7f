#pragma once

#include <span>
#include <string_view>

#include "context.hpp"

namespace echoway::report {

/// Chapter 6 again, part by part. Each writes tables of its own into the context's folder, the same on every run but
/// for columns named `..._us`. docs/report says what they show.
struct Experiment {
  std::string_view name;
  std::string_view what;  ///< For the progress line.
  double cost;            ///< Seconds of one core in a quick run, about: tells how much of the report is left.
  void (*run)(const Context&);
};

[[nodiscard]] std::span<const Experiment> experiments();

void run_match(const Context& context);
void run_single_room(const Context& context);
void run_sensor_count(const Context& context);
void run_weights(const Context& context);
void run_walks(const Context& context);
void run_lights(const Context& context);
void run_ablations(const Context& context);
void run_robustness(const Context& context);
void run_recovery(const Context& context);

}  // namespace echoway::report
