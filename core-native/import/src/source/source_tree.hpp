#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace echoway::import {

/// The files of a plan: a folder, or a zip archive (also one that holds everything in a single folder). Files are found
/// by their base name, nothing is ever unpacked to disk, and no name in an archive is used as a path.
class SourceTree {
 public:
  /// Throws SourceError when there is no such folder or archive, or when it breaks a limit (limits.hpp).
  explicit SourceTree(const std::filesystem::path& path);
  ~SourceTree();
  SourceTree(const SourceTree&) = delete;
  SourceTree& operator=(const SourceTree&) = delete;

  [[nodiscard]] bool has(const std::string& name) const { return entries_.count(name) != 0; }
  /// Throws SourceError when `name` is absent, too large or damaged.
  [[nodiscard]] std::string read(const std::string& name);
  /// How messages call a file of this tree.
  [[nodiscard]] std::string label(const std::string& name) const;

 private:
  struct Archive;
  void open_folder();
  void open_archive();
  [[nodiscard]] std::string read_entry(const std::string& name);

  std::filesystem::path path_;
  std::unique_ptr<Archive> archive_;            ///< Null for a folder.
  std::map<std::string, std::string> entries_;  ///< Base name to file path or archive index.
  std::size_t bytes_read_ = 0;
};

/// The whole of a file, refused above kMaxFileBytes.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace echoway::import
