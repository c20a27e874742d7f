#include <array>

#include "experiment.hpp"

namespace echoway::report {

std::span<const Experiment> experiments() {
  static constexpr std::array kAll{
      Experiment{"match", "match and error surface (figures 6.5-6.7)", 1.0, run_match},
      Experiment{"single-room", "six rooms (tables 6.1, 6.2, figures 6.9, 6.10)", 22.0, run_single_room},
      Experiment{"sensor-count", "8, 12, 15, 24 sensors (figures 6.11, 6.12)", 33.0, run_sensor_count},
      Experiment{"weights", "weight of walls (figures 6.13-6.15)", 3.0, run_weights},
      Experiment{"walks", "walks from room to room (figures 6.17-6.24)", 63.0, run_walks},
      Experiment{"lights", "fluorescent lights (figures 6.25, 6.26)", 5.0, run_lights},
      Experiment{"ablations", "what each part of the tracker buys", 55.0, run_ablations},
      Experiment{"robustness", "one nuisance at a time", 141.0, run_robustness},
      Experiment{"recovery", "carried off blindfold", 89.0, run_recovery},
  };
  return kAll;
}

}  // namespace echoway::report
