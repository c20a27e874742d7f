#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace echoway::fuzz {

/// A file that lives in memory and has a path: readers that take a path read bytes at the speed of memory.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  int descriptor_ = -1;
  std::filesystem::path path_;
};

}  // namespace echoway::fuzz
