#include <optional>
#include <span>

#include "echoway/io/atomic_file.hpp"
#include "echoway/io/logs.hpp"
#include "io/log_columns.hpp"
#include "text/format.hpp"

namespace echoway {
namespace {

// Decimals of each quantity: well below what a sensor or a wearer resolves.
constexpr int kTimeDecimals = 6;
constexpr int kLengthDecimals = 4;
constexpr int kAngleDecimals = 4;
constexpr int kShareDecimals = 6;

constexpr std::size_t kFlushSize = std::size_t{1} << 16U;

/// Collects rows of text and refuses what no reader could take back.
class LogWriter {
 public:
  LogWriter(AtomicFile file, std::filesystem::path name) : file_(std::move(file)), name_(std::move(name)) {}

  void comment(std::string_view key, double value, int decimals) {
    begin_comment(key);
    comment_number(value, decimals);
    end_row();
  }
  void begin_comment(std::string_view key) {
    text_ += "# ";
    text_ += key;
  }
  void comment_word(std::string_view word) {
    if (word.find_first_of(" \t\n\r") != std::string_view::npos) bad_ = true;
    text_ += ' ';
    text_ += word;
  }
  void comment_number(std::optional<double> value, int decimals) {
    text_ += ' ';
    if (value) put(*value, decimals);
    else text_ += '-';
  }
  void header(std::span<const std::string_view> columns) {
    for (const std::string_view column : columns) word(column);
    end_row();
  }
  void number(double value, int decimals) {
    separate();
    put(value, decimals);
  }
  void word(std::string_view word) {
    separate();
    if (word.find_first_of(",\n\r#") != std::string_view::npos) bad_ = true;
    text_ += word;
  }
  void blank() { separate(); }
  void end_row() {
    text_ += '\n';
    first_ = true;
    if (text_.size() >= kFlushSize) flush();
  }

  Status commit() {
    flush();
    if (bad_) return Error{"not written: a value is not finite, or a room's name holds a comma", name_.string()};
    return file_.commit();
  }

 private:
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  void put(double value, int decimals) {
    if (!text::is_writable(value)) bad_ = true;
    text::append_number(text_, value, decimals);
  }
  void flush() {
    file_.write(text_);
    text_.clear();
  }

  AtomicFile file_;
  std::filesystem::path name_;
  std::string text_;
  bool first_ = true;
  bool bad_ = false;
};

void write_belt(LogWriter& out, const BeltHeader& belt) {
  if (belt.sensors) out.comment("sensors", *belt.sensors, 0);
  if (belt.radius_m) out.comment("radius_m", *belt.radius_m, kLengthDecimals);
  if (belt.beam_rad) out.comment("beam_deg", to_degrees(*belt.beam_rad), kAngleDecimals);
  if (belt.slot_s) out.comment("slot_s", *belt.slot_s, kTimeDecimals);
  if (belt.temperature_c) out.comment("temperature_c", *belt.temperature_c, 2);
}

/// One comment line; old readers take it for prose.
void write_restart(LogWriter& out, const LoggedRestart& restart) {
  out.begin_comment("restart");
  out.comment_number(restart.time_s, kTimeDecimals);
  out.comment_word(restart.room.empty() ? "-" : restart.room);
  out.comment_number(restart.position ? std::optional(restart.position->x) : std::nullopt, kLengthDecimals);
  out.comment_number(restart.position ? std::optional(restart.position->y) : std::nullopt, kLengthDecimals);
  out.comment_number(restart.heading ? std::optional(to_degrees(*restart.heading)) : std::nullopt, kAngleDecimals);
  out.end_row();
}

void write_firing(LogWriter& out, const Firing& firing) {
  out.number(firing.time_s, kTimeDecimals);
  out.number(firing.sensor, 0);
  if (firing.has_echo()) out.number(firing.range_m, kLengthDecimals);
  else out.blank();
  out.end_row();
}

void write_place(LogWriter& out, const TruthRow& row) {
  out.number(row.time_s, kTimeDecimals);
  out.word(row.room);
  out.number(row.pose.position.x, kLengthDecimals);
  out.number(row.pose.position.y, kLengthDecimals);
  out.number(to_degrees(row.pose.heading), kAngleDecimals);
}

template <class Rows, class WriteRow>
Status write_rows(const std::filesystem::path& file, std::span<const std::string_view> columns, const Rows& rows,
                  WriteRow write_row) {
  Result<AtomicFile> opened = AtomicFile::create(file);
  if (!opened) return opened.error();
  LogWriter out(std::move(opened).value(), file);
  out.header(columns);
  for (const auto& row : rows) {
    write_row(out, row);
    out.end_row();
  }
  return out.commit();
}

}  // namespace

Status write_scan_log(const ScanLog& log, const std::filesystem::path& file) {
  Result<AtomicFile> opened = AtomicFile::create(file);
  if (!opened) return opened.error();
  LogWriter out(std::move(opened).value(), file);
  write_belt(out, log.belt);
  out.header(kScanColumns);
  auto restart = log.restarts.begin();
  for (const Firing& firing : log.firings) {
    for (; restart != log.restarts.end() && restart->time_s <= firing.time_s; ++restart) write_restart(out, *restart);
    write_firing(out, firing);
  }
  for (; restart != log.restarts.end(); ++restart) write_restart(out, *restart);
  return out.commit();
}

Status write_motion_log(const std::vector<MotionHint>& hints, const std::filesystem::path& file) {
  return write_rows(file, kMotionColumns, hints, [](LogWriter& out, const MotionHint& hint) {
    out.number(hint.time_s, kTimeDecimals);
    out.word(to_word(hint.kind));
    out.number(hint.kind == MotionKind::step ? hint.value : to_degrees(hint.value), kAngleDecimals);
  });
}

Status write_truth_log(const std::vector<TruthRow>& rows, const std::filesystem::path& file) {
  return write_rows(file, kTruthColumns, rows, write_place);
}

Status write_track_log(const std::vector<TrackRow>& rows, const std::filesystem::path& file) {
  return write_rows(file, kTrackColumns, rows, [](LogWriter& out, const TrackRow& row) {
    write_place(out, row.where);
    out.number(row.sigma_m, kLengthDecimals);
    out.number(row.room_probability, kShareDecimals);
    out.word(to_string(row.state));
  });
}

}  // namespace echoway
