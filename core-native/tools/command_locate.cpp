#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "cue_collector.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/io/atomic_file.hpp"
#include "echoway/io/logs.hpp"
#include "option_checks.hpp"
#include "session_options.hpp"

namespace echoway::tools {
namespace {

namespace fs = std::filesystem;

struct LocateOptions {
  SessionOptions session;
  std::string scans;
  std::string motion;
  std::string track;
  std::string cues;
};

TrackRow to_row(const Estimate& estimate, const Building& building) {
  TrackRow row;
  row.where.time_s = estimate.time_s;
  row.where.room = building.room(estimate.room).id;
  row.where.pose = estimate.pose;
  row.sigma_m = estimate.sigma_m;
  row.room_probability = estimate.room_probability;
  row.state = estimate.state;
  return row;
}

// Both logs in order of time. A hint comes before a firing of the same instant, so that the firing profits from it, and
// the wearer's word of where they stand before both.
template <class OnRestart, class OnHint, class OnFiring>
void replay(const ScanLog& scans, const std::vector<MotionHint>& hints, OnRestart on_restart, OnHint on_hint,
            OnFiring on_firing) {
  std::size_t next_hint = 0;
  std::size_t next_restart = 0;
  const auto restart_until = [&](double time_s) {
    while (next_restart < scans.restarts.size() && scans.restarts[next_restart].time_s <= time_s) {
      on_restart(next_restart++);
    }
  };
  for (const Firing& firing : scans.firings) {
    for (; next_hint < hints.size() && hints[next_hint].time_s <= firing.time_s; ++next_hint) {
      restart_until(hints[next_hint].time_s);
      on_hint(hints[next_hint]);
    }
    restart_until(firing.time_s);
    on_firing(firing);
  }
}

Status write_cues(const std::vector<SpokenCue>& cues, const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  file->write("time_s,kind,text\n");
  for (const SpokenCue& cue : cues) {
    file->write(fmt::format("{:.3f},{},{}\n", cue.time_s, cue.kind, csv_quoted(cue.text)));
  }
  return file->commit();
}

/// Whether `a` and `b` are one file or will be; terminals and the like take any number of logs.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  const fs::file_status status = fs::status(a, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored) || fs::equivalent(a, b, ignored);
}

/// No output may take the place of an input or of the other output.
Status check_outputs(const LocateOptions& options) {
  const std::pair<const char*, const std::string&> files[] = {
      {"--scans", options.scans}, {"--motion", options.motion}, {"--track", options.track}, {"--cues", options.cues}};
  for (std::size_t output = 2; output < std::size(files); ++output) {
    const auto& [name, path] = files[output];
    for (std::size_t other = 0; other < output; ++other) {
      if (path.empty() || files[other].second.empty() || !same_file(path, files[other].second)) continue;
      return Error{fmt::format("{} and {} name the same file; give each its own", files[other].first, name), path};
    }
  }
  return success();
}

struct Inputs {
  ScanLog scans;
  std::vector<MotionHint> hints;
  std::vector<Start> restarts;  ///< Where the wearer said that they stand, in the order of the log.
};

Result<Inputs> read_inputs(const LocateOptions& options, const Building& building) {
  Inputs inputs;
  Result<ScanLog> scans = read_scan_log(options.scans, options.session.sensors);
  if (!scans) return scans.error();
  inputs.scans = std::move(*scans);
  if (!options.motion.empty()) {
    Result<std::vector<MotionHint>> hints = read_motion_log(options.motion);
    if (!hints) return hints.error();
    inputs.hints = std::move(*hints);
  }
  for (const LoggedRestart& restart : inputs.scans.restarts) {
    const Result<Start> start = restart.start_in(building);
    if (!start) {
      return Error{fmt::format("at {:.2f} s {}", restart.time_s, start.error().message), options.scans, restart.line};
    }
    inputs.restarts.push_back(*start);
  }
  return inputs;
}

struct Located {
  std::vector<TrackRow> track;
  std::vector<SpokenCue> cues;
  double seconds = 0.0;  ///< That it took.
};

Result<Located> follow(Session& session, const Inputs& inputs, const SpeechStyle& style) {
  CueCollector voice(session, style);
  Located located;
  located.track.reserve(inputs.scans.firings.size());
  Status restarted = success();
  const auto begin = std::chrono::steady_clock::now();
  replay(
      inputs.scans, inputs.hints,
      [&](std::size_t i) {
        if (restarted) restarted = session.restart(inputs.restarts[i]);
      },
      [&](const MotionHint& hint) { session.on_motion(hint); },
      [&](const Firing& firing) {
        if (session.on_firing(firing) && session.estimate().room != kNoRoom) {
          located.track.push_back(to_row(session.estimate(), session.building()));
        }
        voice.collect();
      });
  located.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!restarted) return restarted.error();
  located.cues = voice.cues();
  return located;
}

Status write_outputs(const Located& located, const LocateOptions& options) {
  const Status track = write_track_log(located.track, options.track);
  return track && !options.cues.empty() ? write_cues(located.cues, options.cues) : track;
}

void print(const Located& located, std::size_t firings, std::FILE* out) {
  for (const SpokenCue& cue : located.cues) fmt::print(out, "{:8.2f} s  {}\n", cue.time_s, cue.text);
  fmt::print(out, "{} firings, {} estimates in {:.3f} s: {:.1f} us a firing\n", firings, located.track.size(),
             located.seconds, 1e6 * located.seconds / static_cast<double>(std::max<std::size_t>(1, firings)));
}

int locate(const LocateOptions& options) {
  if (const Status distinct = check_outputs(options); !distinct) return bad_input(distinct.error());
  Result<Building> building = load_building(options.session.building);
  if (!building) return bad_input(building.error());
  const Result<Inputs> inputs = read_inputs(options, *building);
  if (!inputs) return bad_input(inputs.error());
  const Result<std::unique_ptr<Session>> session = options.session.open(std::move(*building), inputs->scans.belt);
  if (!session) return bad_input(session.error());
  const Result<Located> located = follow(**session, *inputs, options.session.speech_style());
  if (!located) return bad_input(located.error());
  if (const Status written = write_outputs(*located, options); !written) return bad_input(written.error());
  print(*located, inputs->scans.firings.size(), words_beside({options.track, options.cues}));
  return kDone;
}

}  // namespace

void add_locate(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("locate", "Room and pose from a scan log");
  auto options = std::make_shared<LocateOptions>();
  options->session.add_to(*command);
  command->add_option("--scans", options->scans, "Scan log (*.scans.csv)")->required()->check(not_empty());
  command->add_option("--motion", options->motion, "Motion log (*.motion.csv)")->check(not_empty());
  command->add_option("--track", options->track, "Track to write")->required()->check(not_empty());
  command->add_option("--cues", options->cues, "What would be spoken and when, to write (time_s,kind,text)")
      ->check(not_empty());
  command->callback([options, &status] { status = locate(*options); });
}

}  // namespace echoway::tools
