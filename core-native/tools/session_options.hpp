#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "echoway/building/building.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/result.hpp"
#include "echoway/session.hpp"
#include "echoway/speech/speaker.hpp"

namespace echoway::tools {

/// The options that `locate` and `monitor` share.
struct SessionOptions {
  std::string building;
  std::string start;
  std::string method = "bayes";
  std::optional<int> sensors;
  std::optional<double> radius_m;
  std::optional<double> beam_deg;
  std::uint64_t seed = 1;
  std::string destination;
  bool avoid_stairs = false;
  std::string language = "en";
  std::string directions = "sides";
  std::string lengths = "feet";

  void add_to(CLI::App& command);

  /// Belt: the defaults, then what the log's header says, then the command line.
  [[nodiscard]] BeltConfig belt(const BeltHeader& header) const;
  /// A session in the building, already on its way to the destination where one is given.
  [[nodiscard]] Result<std::unique_ptr<Session>> open(Building building_model, const BeltHeader& header) const;
  [[nodiscard]] SpeechStyle speech_style() const;

 private:
  [[nodiscard]] Result<SessionConfig> config(const Building& building_model, const BeltHeader& header) const;
};

/// `R[,x_m,y_m[,heading_deg]]`; a field left blank is unknown (`R,,,90`: the room and the heading).
Result<Start> parse_start(const std::string& text, const Building& building);

}  // namespace echoway::tools
