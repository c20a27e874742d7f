#include "plans/scratch_folder.hpp"

#include <unistd.h>

#include <fstream>
#include <system_error>

namespace echoway::plans {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& name)
    : path_(fs::temp_directory_path() / ("echoway-" + name + "-" + std::to_string(::getpid()))) {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  fs::create_directories(path_, ignored);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScratchFolder::write(const std::string& file, std::string_view bytes) const {
  std::ofstream(path_ / file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace echoway::plans
