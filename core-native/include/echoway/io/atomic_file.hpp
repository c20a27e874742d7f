#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "echoway/result.hpp"

namespace echoway {

/// An output file that appears whole or not at all: it grows beside its place under a temporary name and is renamed
/// into it by commit(). Without commit() (an error, an early return, an exception in a tool) nothing is left and a file
/// that was there before stays as it was. Guards against failing processes and full disks, not against a power cut.
///
/// A path that names something other than a regular file (a terminal, a pipe, /dev/null) or what this process has open
/// already (/dev/stdout, whatever stands behind it) is written directly; a symbolic link is followed, not replaced.
class AtomicFile {
 public:
  /// Fails when the folder does not exist, the path is a folder, or the place cannot be written.
  static Result<AtomicFile> create(const std::filesystem::path& file);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// A failure is remembered and reported by close() or commit().
  void write(std::string_view bytes) noexcept;

  /// Everything is on its way to the disk and the file handle is free; commit() may still follow. For writing many
  /// files that shall appear together.
  Status close();

  /// Puts the file in its place. To be called once; nothing more can be written.
  Status commit();

 private:
  AtomicFile() = default;
  void discard() noexcept;
  [[nodiscard]] Error failure(int error) const;

  struct Closer {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Closer> handle_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< Empty when written directly, and after commit().
  int error_ = 0;                    ///< errno of the first failure.
};

/// The open file that a path is another name of, by its number: 1 for /dev/stdout, 3 for /dev/fd/3 and /proc/self/fd/3,
/// also through links to these; none for any other path. Whether it is open is not looked at.
[[nodiscard]] std::optional<int> descriptor_named_by(const std::filesystem::path& file);

/// Writes `text` as the whole of a file, all of it or nothing.
Status write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace echoway
