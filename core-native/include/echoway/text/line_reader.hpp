#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "echoway/result.hpp"

namespace echoway::text {

/// Longest line that any of our files may have, bytes.
inline constexpr std::size_t kMaxLineLength = 4096;

/// Reads a text file line by line in bounded memory. A byte order mark is skipped; CR LF and LF both end a line; the
/// last line may lack its end.
class LineReader {
 public:
  static Result<LineReader> open(const std::filesystem::path& file);

  /// The next line without its end, valid until the next call; nothing at the end of the file or after an error.
  std::optional<std::string_view> next();

  /// 1-based number of the line that next() returned last; 0 before the first.
  [[nodiscard]] int line() const noexcept { return line_; }

  /// Whether the line that next() returned last had its end; a file that was cut short ends in one that has none.
  [[nodiscard]] bool line_ended() const noexcept { return line_ended_; }

  /// What stopped next(): a read error, a line that is too long, or bytes that no text has. Nothing at a proper end.
  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }

  /// An error at the current line.
  [[nodiscard]] Error error_here(std::string message) const { return Error{std::move(message), name_, line_}; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };

  LineReader(std::unique_ptr<std::FILE, Closer> file, std::string name);
  bool refill();
  std::optional<std::string_view> fail(std::string message, int line);

  std::unique_ptr<std::FILE, Closer> file_;
  std::string name_;
  std::unique_ptr<char[]> buffer_;
  std::size_t begin_ = 0;  ///< Unread bytes of buffer_ are [begin_, end_).
  std::size_t end_ = 0;
  bool at_end_ = false;
  bool line_ended_ = false;
  int line_ = 0;
  std::optional<Error> error_;
};

}  // namespace echoway::text
