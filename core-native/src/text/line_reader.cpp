#include "echoway/text/line_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <system_error>

namespace echoway::text {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 16U;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string reason(int error) { return std::generic_category().message(error); }

/// Control characters other than tab: the mark of a file that is not text at all.
bool is_binary(char c) noexcept { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; }

}  // namespace

LineReader::LineReader(std::unique_ptr<std::FILE, Closer> file, std::string name)
    : file_(std::move(file)), name_(std::move(name)), buffer_(std::make_unique_for_overwrite<char[]>(kBufferSize)) {}

Result<LineReader> LineReader::open(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return Error{"is a folder, not a file", file.string()};
  std::unique_ptr<std::FILE, Closer> handle(std::fopen(file.c_str(), "rb"));
  if (!handle) return Error{"cannot be opened: " + reason(errno), file.string()};
  return LineReader(std::move(handle), file.string());
}

bool LineReader::refill() {
  std::memmove(buffer_.get(), buffer_.get() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::size_t got = std::fread(buffer_.get() + end_, 1, kBufferSize - end_, file_.get());
  end_ += got;
  if (got == 0) at_end_ = true;
  return got > 0;
}

std::optional<std::string_view> LineReader::fail(std::string message, int line) {
  error_ = Error{std::move(message), name_, line};
  return std::nullopt;
}

std::optional<std::string_view> LineReader::next() {
  if (error_) return std::nullopt;
  const auto find_end = [this](std::size_t from) {
    return std::find(buffer_.get() + begin_ + from, buffer_.get() + end_, '\n') - buffer_.get();
  };
  std::size_t searched = 0;
  auto stop = static_cast<std::size_t>(find_end(0));
  while (stop == end_ && !at_end_ && end_ - begin_ <= kMaxLineLength) {
    searched = end_ - begin_;
    refill();
    stop = static_cast<std::size_t>(find_end(searched));
  }
  if (at_end_ && std::ferror(file_.get()) != 0) return fail("cannot be read: " + reason(EIO), 0);
  if (begin_ == end_) return std::nullopt;
  if (line_ == INT_MAX) return fail("has too many lines", line_);
  std::string_view line(buffer_.get() + begin_, stop - begin_);
  line_ended_ = stop < end_;
  begin_ = std::min(stop + 1, end_);
  ++line_;
  if (line_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() > kMaxLineLength) {
    return fail("line is longer than " + std::to_string(kMaxLineLength) + " characters", line_);
  }
  if (std::any_of(line.begin(), line.end(), is_binary)) {
    return fail("holds control characters: not a text file, or saved as UTF-16; save it as UTF-8", line_);
  }
  return line;
}

}  // namespace echoway::text
