#include "echoway/io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <system_error>
#include <utility>

#include "echoway/text/number.hpp"

namespace echoway {
namespace {

namespace fs = std::filesystem;

/// A name beside `target` that no other writer of this or another process uses.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  const std::string suffix = ".partial-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  return target.parent_path() / ("." + target.filename().string() + suffix);
}

constexpr int kMostLinks = 40;  // As the kernel follows.

fs::path follow_link(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  const fs::path real = fs::weakly_canonical(file, error);
  return error ? file : real;
}

std::string describe(int error) { return "cannot be written: " + std::generic_category().message(error); }

/// O_EXCL: never writes through something that another process put there. 0666: the umask decides, as for any new file.
std::FILE* open_new(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return nullptr;
  std::FILE* handle = ::fdopen(descriptor, "wb");
  if (handle == nullptr) {
    ::close(descriptor);
    ::unlink(file.c_str());
  }
  return handle;
}

/// Another handle on what is open already: it goes on where the others are and cuts nothing off (`>> file`).
std::FILE* open_again(int descriptor) {
  const int again = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (again < 0) return nullptr;
  std::FILE* handle = ::fdopen(again, "wb");
  if (handle == nullptr) {
    const int error = errno;
    ::close(again);
    errno = error;
  }
  return handle;
}

}  // namespace

std::optional<int> descriptor_named_by(const fs::path& file) {
  std::error_code error;
  const fs::path open_files = fs::canonical("/proc/self/fd", error);
  if (error) return std::nullopt;
  fs::path at = fs::absolute(file, error);
  for (int links = 0; links < kMostLinks && !error; ++links) {
    if (fs::weakly_canonical(at.parent_path(), error) == open_files) {
      const std::optional<long long> number = text::parse_integer(at.filename().string());
      return number && *number >= 0 && *number <= INT_MAX ? std::optional(static_cast<int>(*number)) : std::nullopt;
    }
    const fs::path next = fs::read_symlink(at, error);
    at = at.parent_path() / next;  // Which an absolute `next` replaces.
  }
  return std::nullopt;
}

Result<AtomicFile> AtomicFile::create(const fs::path& file) {
  AtomicFile out;
  if (const std::optional<int> descriptor = descriptor_named_by(file)) {
    out.target_ = file;
    out.handle_.reset(open_again(*descriptor));
    if (!out.handle_) return Error{describe(errno), file.string()};
    return out;
  }
  out.target_ = follow_link(file);
  std::error_code ignored;
  const fs::file_status status = fs::status(out.target_, ignored);
  if (fs::is_directory(status)) return Error{"is a folder; name a file in it", file.string()};
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    out.handle_.reset(std::fopen(out.target_.c_str(), "wb"));
  } else {
    out.temporary_ = temporary_beside(out.target_);
    out.handle_.reset(open_new(out.temporary_));
  }
  if (!out.handle_) {
    const int error = errno;
    out.temporary_.clear();
    return Error{describe(error), file.string()};
  }
  return out;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : handle_(std::move(other.handle_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      error_(other.error_) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    discard();
    handle_ = std::move(other.handle_);
    target_ = std::move(other.target_);
    temporary_ = std::exchange(other.temporary_, {});
    error_ = other.error_;
  }
  return *this;
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() noexcept {
  handle_.reset();
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

Error AtomicFile::failure(int error) const { return Error{describe(error), target_.string()}; }

void AtomicFile::write(std::string_view bytes) noexcept {
  if (error_ != 0) return;
  if (!handle_) {
    error_ = EBADF;
  } else if (std::fwrite(bytes.data(), 1, bytes.size(), handle_.get()) != bytes.size()) {
    error_ = errno;
  }
}

Status AtomicFile::close() {
  if (handle_ && std::fclose(handle_.release()) != 0 && error_ == 0) error_ = errno;
  if (error_ == 0) return success();
  const Error error = failure(error_);
  discard();
  return error;
}

Status AtomicFile::commit() {
  if (Status closed = close(); !closed) return closed;
  if (temporary_.empty()) return success();
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const Error error = failure(errno);
    discard();
    return error;
  }
  temporary_.clear();
  return success();
}

Status write_file(const fs::path& file, std::string_view text) {
  Result<AtomicFile> out = AtomicFile::create(file);
  if (!out) return out.error();
  out->write(text);
  return out->commit();
}

}  // namespace echoway
