#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "echoway/io/logs.hpp"
#include "echoway/locate/start_check.hpp"
#include "io/csv.hpp"
#include "io/log_columns.hpp"
#include "echoway/text/number.hpp"
#include "echoway/text/tokens.hpp"
#include "text/utf8.hpp"

namespace echoway {
namespace {

using Problem = std::optional<std::string>;

constexpr double kMaxTime = 1e12;   ///< Seconds; room for any epoch, and microseconds still resolve.
constexpr double kMaxLength = 1e8;  ///< Metres, as for coordinates of a building.
constexpr double kMaxRange = 1e4;   ///< Metres: catches a log in millimetres, passes any echo.
constexpr double kMaxAngle = 1e9;   ///< Degrees; a drifting heading may count many turns.

/// The time of a row; rows must come in order of time, equal times are fine.
class Clock {
 public:
  Problem read(const csv::Row& row, double& time) {
    const Result<double> value = row.number(0, kMaxTime);
    if (!value) return value.error().message;
    if (*value < last_) return "time_s goes back; sort the rows by time";
    time = last_ = *value;
    return std::nullopt;
  }

 private:
  double last_ = -std::numeric_limits<double>::infinity();
};

Problem read_number(const csv::Row& row, std::size_t column, double limit, double& out) {
  const Result<double> value = row.number(column, limit);
  if (!value) return value.error().message;
  out = *value;
  return std::nullopt;
}

// --- Scan logs
// ---------------------------------------------------------------------------------------------------------

struct BeltKey {
  std::string_view key;
  double low, high;
  void (*set)(BeltHeader&, double);
};

constexpr BeltKey kBeltKeys[] = {
    {"sensors", 1, kMaxSensors, [](BeltHeader& b, double v) { b.sensors = static_cast<int>(v); }},
    {"radius_m", 0, 2, [](BeltHeader& b, double v) { b.radius_m = v; }},
    {"beam_deg", 0.01, 360, [](BeltHeader& b, double v) { b.beam_rad = degrees(v); }},
    {"slot_s", 1e-6, 60, [](BeltHeader& b, double v) { b.slot_s = v; }},
    {"temperature_c", -60, 100, [](BeltHeader& b, double v) { b.temperature_c = v; }},
};

/// Unlike text::split_tokens(): a comment is prose, in which quotes and # mean nothing.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = text::trim(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// `key value` sets something; any other comment is prose.
Problem read_belt_comment(std::string_view comment, BeltHeader& belt) {
  const std::vector<std::string_view> words = words_of(comment);
  if (words.size() != 2) return std::nullopt;
  for (const BeltKey& known : kBeltKeys) {
    if (known.key != words[0]) continue;
    const auto value = text::parse_number(words[1]);
    const bool whole = known.key != "sensors" || (value && *value == std::floor(*value));
    if (!value || *value < known.low || *value > known.high || !whole) {
      return "'" + std::string(words[1]) + "' is no sensible value for " + std::string(known.key);
    }
    known.set(belt, *value);
  }
  return std::nullopt;
}

/// `restart time_s room x_m y_m heading_deg`, a `-` where something was not said; any other comment is prose.
Problem read_restart(std::string_view comment, int line, std::vector<LoggedRestart>& restarts) {
  const std::vector<std::string_view> words = words_of(comment);
  if (words.size() != 6 || words[0] != "restart") return std::nullopt;
  std::array<std::optional<double>, 6> values;
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}, std::size_t{4}, std::size_t{5}}) {
    if (words[i] == "-") continue;
    values[i] = text::parse_number(words[i]);
    const double limit = i == 1 ? kMaxTime : i == 5 ? kMaxAngle : kMaxLength;
    if (!values[i] || std::abs(*values[i]) > limit) {
      return "'" + std::string(words[i]) + "' is no sensible number for a restart";
    }
  }
  if (!values[1]) return "a restart needs its time";
  if (values[3].has_value() != values[4].has_value()) return "a restart needs both x_m and y_m, or a - for each";
  if (words[2] == "-" && (values[3] || values[5])) return "the place of a restart needs its room";
  if (!restarts.empty() && *values[1] < restarts.back().time_s) return "the time of a restart goes back";
  if (!text::is_utf8(words[2])) return "room is not valid UTF-8";
  LoggedRestart restart;
  restart.line = line;
  restart.time_s = *values[1];
  if (words[2] != "-") restart.room = words[2];
  if (values[3]) restart.position = Vec2{*values[3], *values[4]};
  if (values[5]) restart.heading = wrap_angle(degrees(*values[5]));
  restarts.push_back(std::move(restart));
  return std::nullopt;
}

Problem read_firing(const csv::Row& row, int sensors, Clock& clock, Firing& firing) {
  if (auto problem = clock.read(row, firing.time_s)) return problem;
  const auto sensor = text::parse_integer(row.text(1));
  if (!sensor || *sensor < 0 || *sensor >= sensors) {
    return "sensor is '" + std::string(row.text(1)) + "', not a number from 0 to " + std::to_string(sensors - 1);
  }
  firing.sensor = static_cast<int>(*sensor);
  if (row.text(2).empty()) return std::nullopt;
  if (auto problem = read_number(row, 2, kMaxRange, firing.range_m)) return problem;
  if (firing.range_m < 0.0) return "range_m is negative; leave it blank when there was no echo";
  return std::nullopt;
}

// --- Motion, truth and tracks
// ------------------------------------------------------------------------------------------

Problem read_motion(const csv::Row& row, Clock& clock, MotionHint& hint) {
  if (auto problem = clock.read(row, hint.time_s)) return problem;
  const std::optional<MotionKind> kind = motion_kind_from(row.text(1));
  if (!kind) return "kind is '" + std::string(row.text(1)) + "', not step, yaw_rate_dps or heading_deg";
  hint.kind = *kind;
  if (auto problem = read_number(row, 2, kMaxAngle, hint.value)) return problem;
  if (hint.kind == MotionKind::step) {
    if (hint.value != 1.0) {
      return "the value of a step is '" + std::string(row.text(2)) + "', not 1; each step has a row";
    }
    return std::nullopt;
  }
  hint.value = degrees(hint.value);
  return std::nullopt;
}

/// `room` may be blank in a track only: a locator that has no idea yet.
Problem read_place(const csv::Row& row, Clock& clock, bool room_required, TruthRow& out) {
  out.line = row.line();
  if (auto problem = clock.read(row, out.time_s)) return problem;
  out.room = row.text(1);
  if (out.room.empty() && room_required) return "room is missing";
  if (!text::is_utf8(out.room)) return "room is not valid UTF-8";
  if (auto problem = read_number(row, 2, kMaxLength, out.pose.position.x)) return problem;
  if (auto problem = read_number(row, 3, kMaxLength, out.pose.position.y)) return problem;
  double heading_deg = 0.0;
  if (auto problem = read_number(row, 4, kMaxAngle, heading_deg)) return problem;
  out.pose.heading = wrap_angle(degrees(heading_deg));
  return std::nullopt;
}

Problem read_track(const csv::Row& row, Clock& clock, TrackRow& out) {
  if (auto problem = read_place(row, clock, false, out.where)) return problem;
  if (auto problem = read_number(row, 5, kMaxLength, out.sigma_m)) return problem;
  if (out.sigma_m < 0.0) return "sigma_m is negative";
  if (auto problem = read_number(row, 6, 1.0, out.room_probability)) return problem;
  if (out.room_probability < 0.0) return "room_probability is negative";
  const std::optional<TrackState> state = track_state_from(row.text(7));
  if (!state) return "state is '" + std::string(row.text(7)) + "', not searching, tracking or lost";
  out.state = *state;
  return std::nullopt;
}

template <class T, class ReadRow>
Result<std::vector<T>> read_rows(const std::filesystem::path& file, std::span<const std::string_view> columns,
                                 ReadRow read_row, csv::Handlers handlers = {}) {
  std::vector<T> rows;
  Clock clock;
  handlers.row = [&](const csv::Row& row) {
    csv::reserve_next(rows);
    Problem problem = read_row(row, clock, rows.emplace_back());
    if (problem) rows.pop_back();
    return problem;
  };
  if (const Status status = csv::read(file, columns, handlers); !status) return status.error();
  return rows;
}

}  // namespace

BeltConfig BeltHeader::apply_to(BeltConfig defaults) const noexcept {
  if (sensors) defaults.sensors = *sensors;
  if (radius_m) defaults.radius_m = *radius_m;
  if (beam_rad) defaults.beam_rad = *beam_rad;
  if (slot_s) defaults.slot_s = *slot_s;
  return defaults;
}

Result<Start> LoggedRestart::start_in(const Building& building) const {
  Start start;
  if (room.empty()) return start;
  const RoomIndex found = building.find_room(room);
  if (found == kNoRoom) {
    return Error{"the walk was started again in room " + room + ", which the building does not have"};
  }
  start.room = found;
  start.position = position;
  start.heading = heading;
  if (const Status good = check_start(start, building); !good) return good.error();
  return start;
}

Result<ScanLog> read_scan_log(const std::filesystem::path& file, std::optional<int> sensors) {
  ScanLog log;
  Clock clock;
  csv::Handlers handlers;
  handlers.comment = [&](std::string_view comment, int line) {
    auto problem = read_belt_comment(comment, log.belt);
    return problem ? problem : read_restart(comment, line, log.restarts);
  };
  handlers.later_comment = [&](std::string_view comment, int line) {
    return read_restart(comment, line, log.restarts);
  };
  handlers.row = [&](const csv::Row& row) {
    csv::reserve_next(log.firings);
    const int count = sensors.value_or(log.belt.apply_to({}).sensors);
    Problem problem = read_firing(row, count, clock, log.firings.emplace_back());
    if (problem) log.firings.pop_back();
    return problem;
  };
  if (const Status status = csv::read(file, kScanColumns, handlers); !status) return status.error();
  return log;
}

Result<std::vector<MotionHint>> read_motion_log(const std::filesystem::path& file) {
  return read_rows<MotionHint>(file, kMotionColumns, read_motion);
}

Result<std::vector<TruthRow>> read_truth_log(const std::filesystem::path& file) {
  return read_rows<TruthRow>(file, kTruthColumns, [](const csv::Row& row, Clock& clock, TruthRow& out) {
    return read_place(row, clock, true, out);
  });
}

Result<std::vector<TrackRow>> read_track_log(const std::filesystem::path& file) {
  csv::Handlers handlers;
  handlers.is_cut = is_cut_track_state;
  return read_rows<TrackRow>(file, kTrackColumns, read_track, std::move(handlers));
}

}  // namespace echoway
