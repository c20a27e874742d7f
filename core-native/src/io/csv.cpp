#include "io/csv.hpp"

#include <algorithm>
#include <cmath>

#include "text/format.hpp"
#include "echoway/text/number.hpp"
#include "echoway/text/tokens.hpp"

namespace echoway::csv {
namespace {

std::string join(std::span<const std::string_view> columns) {
  std::string out;
  for (const std::string_view column : columns) {
    if (!out.empty()) out += ',';
    out += column;
  }
  return out;
}

bool starts_with_columns(std::span<const std::string_view> header, std::span<const std::string_view> columns) {
  return header.size() >= columns.size() && std::equal(columns.begin(), columns.end(), header.begin());
}

}  // namespace

bool is_cut_number(std::string_view field) {
  return !text::parse_number(field) && text::parse_number(std::string(field) + '0');
}

Result<double> Row::number(std::size_t column, double limit) const {
  const std::string_view field = fields_[column];
  const std::string name(columns_[column]);
  if (field.empty()) return Error{name + " is missing"};
  const std::optional<double> value = text::parse_number(field);
  if (!value) return Error{name + " is '" + std::string(field) + "', not a finite number"};
  if (std::abs(*value) > limit) return Error{name + " is " + std::string(field) + ", beyond any sensible value"};
  return *value;
}

Status read(const std::filesystem::path& file, std::span<const std::string_view> columns, const Handlers& handlers) {
  Result<text::LineReader> opened = text::LineReader::open(file);
  if (!opened) return opened.error();
  text::LineReader reader = std::move(opened).value();
  std::array<std::string_view, kMaxColumns> fields;
  std::size_t width = 0;
  std::size_t rows = 0;
  while (const std::optional<std::string_view> raw = reader.next()) {
    const std::string_view line = text::trim(*raw);
    if (line.empty()) continue;
    if (line.front() == '#') {
      const auto& handler = width > 0 ? handlers.later_comment : handlers.comment;
      const auto problem = handler ? handler(text::trim(line.substr(1)), reader.line()) : std::nullopt;
      if (problem && !reader.line_ended()) break;
      if (problem) return reader.error_here(*problem);
      continue;
    }
    const std::size_t count = text::split_at_commas(line, fields);
    if (width == 0) {
      if (!starts_with_columns({fields.data(), std::min(count, kMaxColumns)}, columns) || count > kMaxColumns) {
        return reader.error_here("the header line must be '" + join(columns) + "'");
      }
      width = count;
      continue;
    }
    if (count != width) {
      if (count < width && !reader.line_ended()) break;  // A log that was cut short: every whole row of it counts.
      return reader.error_here("has " + std::to_string(count) + " fields where the header has " +
                               std::to_string(width));
    }
    if (++rows > kMaxRows) {
      return reader.error_here("has more than " + std::to_string(kMaxRows) + " rows; split the log");
    }
    if (const auto problem = handlers.row(Row({fields.data(), count}, columns, reader.line()))) {
      // Every field of it is there: only the last can have lost something.
      if (!reader.line_ended() && count == columns.size() && handlers.is_cut(fields[count - 1])) break;
      return reader.error_here(*problem);
    }
  }
  if (reader.error()) return *reader.error();
  if (width == 0) {
    return Error{"has no header line; it must be '" + join(columns) + "'", file.string(), reader.line() + 1};
  }
  return success();
}

}  // namespace echoway::csv
