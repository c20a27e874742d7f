#include <fmt/core.h>

#include <memory>
#include <string>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/units.hpp"
#include "option_checks.hpp"
#include "score.hpp"

namespace echoway::tools {
namespace {

struct ScoreOptions {
  std::string building;
  std::string track;
  std::string truth;
};

std::string metres_and_feet(double metres) {
  return fmt::format("{:.3f} m ({:.2f} ft)", metres, metres / kMetresPerFoot);
}

int score(const ScoreOptions& options) {
  const Result<Building> building = load_building(options.building);
  if (!building) return bad_input(building.error());
  const Result<std::vector<TrackRow>> track = read_track_log(options.track);
  if (!track) return bad_input(track.error());
  const Result<std::vector<TruthRow>> truth = read_truth_log(options.truth);
  if (!truth) return bad_input(truth.error());
  const Result<Score> result = score_track(*track, *truth, *building, {options.track, options.truth});
  if (!result) return bad_input(result.error());
  fmt::print("rows             {}\n", result->rows);
  if (result->rows_nowhere > 0) fmt::print("without a room   {}, left out\n", result->rows_nowhere);
  fmt::print("position error   mean {}, median {}, worst {}\n", metres_and_feet(result->mean_error_m),
             metres_and_feet(result->median_error_m), metres_and_feet(result->worst_error_m));
  fmt::print("heading error    mean {:.1f} deg\n", to_degrees(result->mean_heading_error_rad));
  fmt::print("right room       {:.1f} %\n", 100.0 * result->right_room_share);
  fmt::print("within 2 sigma   {:.1f} %\n", 100.0 * result->within_two_sigma_share);
  return 0;
}

}  // namespace

void add_score(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("score", "Hold a track against the truth");
  auto options = std::make_shared<ScoreOptions>();
  command->add_option("--building", options->building, "Building folder")->required()->check(not_empty());
  command->add_option("--track", options->track, "Track to judge")->required()->check(not_empty());
  command->add_option("--truth", options->truth, "Truth log (*.truth.csv)")->required()->check(not_empty());
  command->callback([options, &status] { status = score(*options); });
}

}  // namespace echoway::tools
