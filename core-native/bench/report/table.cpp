#include "table.hpp"

#include <stdexcept>

#include "echoway/io/atomic_file.hpp"

namespace echoway::report {

void Table::write(const std::filesystem::path& path) const {
  if (const Status done = write_file(path, text_); !done) throw std::runtime_error(done.error().to_string());
}

}  // namespace echoway::report
