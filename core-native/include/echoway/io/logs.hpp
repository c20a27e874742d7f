#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"
#include "echoway/geometry/pose2.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/motion/motion_hint.hpp"
#include "echoway/result.hpp"

namespace echoway {

/// What a scan log's comment lines say of its belt; unset where they say nothing.
struct BeltHeader {
  std::optional<int> sensors;
  std::optional<double> radius_m;
  std::optional<double> beam_rad;
  std::optional<double> slot_s;
  std::optional<double> temperature_c;  ///< Of the air, not that with which the belt computed: SessionConfig::air_c.

  /// `defaults` with everything about the belt itself that is set here put in its place.
  [[nodiscard]] BeltConfig apply_to(BeltConfig defaults) const noexcept;
};

/// The wearer said where they stand, and the tracker started over there (`Session::restart`).
struct LoggedRestart {
  double time_s = 0.0;
  std::string room;               ///< By id; blank: looked for everywhere.
  std::optional<Vec2> position;   ///< In the room's frame.
  std::optional<double> heading;  ///< The same, radians.
  int line = 0;                   ///< Of the log that it was read from; 0: of none.

  /// Where to start in `building`; fails when nobody can stand there (see check_start()).
  [[nodiscard]] Result<Start> start_in(const Building& building) const;
};

struct ScanLog {
  BeltHeader belt;
  std::vector<Firing> firings;          ///< In order of time,
  std::vector<LoggedRestart> restarts;  ///< the same.
};

/// A row of a truth log or of a track; poses in the room's frame. Rooms are named by id, since a log stands alone.
struct TruthRow {
  double time_s = 0.0;
  std::string room;
  Pose2 pose{};
  int line = 0;  ///< Of the log that it was read from; 0: of none.
};
struct TrackRow {
  TruthRow where;
  double sigma_m = 0.0;
  double room_probability = 0.0;
  TrackState state = TrackState::searching;
};

// Readers fail with file:line of the first row that is malformed, not finite or out of order.

/// Rows are held to a belt of `sensors`; where that is not given, of as many as the log says, else of the usual belt's.
Result<ScanLog> read_scan_log(const std::filesystem::path& file, std::optional<int> sensors = std::nullopt);
Result<std::vector<MotionHint>> read_motion_log(const std::filesystem::path& file);
Result<std::vector<TruthRow>> read_truth_log(const std::filesystem::path& file);
Result<std::vector<TrackRow>> read_track_log(const std::filesystem::path& file);

// Writers: a file appears whole or not at all (written beside, then renamed).
Status write_scan_log(const ScanLog& log, const std::filesystem::path& file);
Status write_motion_log(const std::vector<MotionHint>& hints, const std::filesystem::path& file);
Status write_truth_log(const std::vector<TruthRow>& rows, const std::filesystem::path& file);
Status write_track_log(const std::vector<TrackRow>& rows, const std::filesystem::path& file);

[[nodiscard]] const char* to_string(TrackState state) noexcept;

}  // namespace echoway
