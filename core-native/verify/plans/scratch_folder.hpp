#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace echoway::plans {

/// A folder of this process's own below the system's temporary one (TMPDIR), emptied on construction and on
/// destruction.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  void write(const std::string& file, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

}  // namespace echoway::plans
