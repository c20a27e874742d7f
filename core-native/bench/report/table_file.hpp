#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "report/table.hpp"

namespace echoway::report {

/// A CSV table in a file that several runs add to: it gets its head when it is new, and each row is in it at once.
class TableFile {
 public:
  /// Throws std::runtime_error when the file cannot be written.
  TableFile(const std::filesystem::path& file, std::string_view columns);

  /// One row, as Table::add().
  template <class... Cells>
  void add(const Cells&... cells) {
    Table row;
    row.add(cells...);
    append(row.text());
  }

 private:
  void append(const std::string& text);

  struct Closer {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> handle_;
  std::filesystem::path file_;
};

}  // namespace echoway::report
