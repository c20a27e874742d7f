#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "echoway/result.hpp"
#include "echoway/text/line_reader.hpp"

namespace echoway::csv {

/// Rows that a log may have: 26 hours of firings. Keeps a hostile file from filling the memory.
inline constexpr std::size_t kMaxRows = 1'500'000;
inline constexpr std::size_t kMaxColumns = 64;

/// The fields of one row, as many as the header has.
class Row {
 public:
  Row(std::span<const std::string_view> fields, std::span<const std::string_view> columns, int line)
      : fields_(fields), columns_(columns), line_(line) {}

  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }

  /// Where it stands in the file, 1-based.
  [[nodiscard]] int line() const { return line_; }

  /// A finite number whose magnitude is at most `limit`, or why it is none.
  [[nodiscard]] Result<double> number(std::size_t column, double limit) const;

 private:
  std::span<const std::string_view> fields_;
  std::span<const std::string_view> columns_;
  int line_;
};

/// Whether `field` is no number but begins one: "", "-", "1e".
[[nodiscard]] bool is_cut_number(std::string_view field);

struct Handlers {
  /// Each comment line before the header, without `#`, and its number; returns what is wrong with it.
  std::function<std::optional<std::string>(std::string_view, int)> comment = nullptr;
  /// The same for those after it.
  std::function<std::optional<std::string>(std::string_view, int)> later_comment = nullptr;
  /// Each row; returns what is wrong with it, and keeps nothing of it then.
  std::function<std::optional<std::string>(const Row&)> row;
  /// Whether a field of the last of `columns` is what a cut leaves of one.
  std::function<bool(std::string_view)> is_cut = is_cut_number;
};

/// Reads a log: `#` comments, a header line whose first columns are `columns` (further ones may follow), rows. Fails at
/// the first line that is malformed or that a handler refuses, unless it is the last, lacks its end and may be the
/// beginning of a good one: a log that was cut short is read up to there.
Status read(const std::filesystem::path& file, std::span<const std::string_view> columns, const Handlers& handlers);

/// Growth by doubling would pass a log's memory limit on its last step; this keeps the largest buffer at kMaxRows.
template <class Vector>
void reserve_next(Vector& rows) {
  if (rows.size() == rows.capacity() && rows.capacity() < kMaxRows) {
    rows.reserve(std::min(kMaxRows, std::max<std::size_t>(256, 2 * rows.capacity())));
  }
}

}  // namespace echoway::csv
