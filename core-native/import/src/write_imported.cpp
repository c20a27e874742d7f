#include <cstdlib>
#include <string>
#include <system_error>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"
#include "echoway/import/import.hpp"

namespace echoway::import {
namespace {

namespace fs = std::filesystem;

// A folder of its own for as long as it lives.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "echoway-import-XXXXXX").string();
    if (!error && mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

}  // namespace

Status write_imported(const Building& building, const fs::path& dir, std::vector<Finding>& findings) {
  const ScratchFolder scratch;
  if (scratch.path().empty()) return Error{"no folder for temporary files can be made"};
  if (Status written = write_building(building, scratch.path()); !written) return written;
  findings = check_building(scratch.path());
  const Result<Building> loaded = load_building(scratch.path());
  if (!loaded) return loaded.error();
  return write_building(*loaded, dir);
}

}  // namespace echoway::import
