#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>

namespace echoway::report {

/// A CSV table that grows row by row.
class Table {
 public:
  /// `columns`: names separated by commas.
  explicit Table(std::string_view columns) : text_(std::string(columns) + "\n") {}
  /// Without a head: rows for another table.
  Table() = default;

  /// One row; numbers are written with six digits, text as it is (it must hold no comma).
  template <class... Cells>
  void add(const Cells&... cells) {
    bool first = true;
    (cell(cells, first), ...);
    text_ += '\n';
  }
  /// Rows that another table without a head has gathered.
  void append(const std::string& rows) { text_ += rows; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

  /// Throws std::runtime_error when the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  template <class Cell>
  void cell(const Cell& value, bool& first) {
    if (!first) text_ += ',';
    first = false;
    if constexpr (std::is_floating_point_v<Cell>) {
      text_ += fmt::format("{:.6g}", value);
    } else {
      text_ += fmt::format("{}", value);
    }
  }

  std::string text_;
};

/// A cell with so many decimals.
[[nodiscard]] inline std::string fixed(double value, int decimals) { return fmt::format("{:.{}f}", value, decimals); }

}  // namespace echoway::report
