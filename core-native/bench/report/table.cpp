#include "table.hpp"

#include <stdexcept>

#include "echoway/io/atomic_file.hpp"

namespace echoway::report {

void Table::write(const std::filesystem::path& path) const {
  auto file = AtomicFile::create(path);
  if (!file) throw std::runtime_error(file.error().to_string());
  file->write(text_);
  if (const Status done = file->commit(); !done) throw std::runtime_error(done.error().to_string());
}

}  // namespace echoway::report
