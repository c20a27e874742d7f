#pragma once

#include "support/process.hpp"

namespace echoway::test {

using TempDir = TemporaryFolder;

inline std::string read_text(const std::filesystem::path& file) { return read_file(file); }

}  // namespace echoway::test
