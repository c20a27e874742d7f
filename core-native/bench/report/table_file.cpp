#include "table_file.hpp"

#include <stdexcept>

namespace echoway::report {

TableFile::TableFile(const std::filesystem::path& file, std::string_view columns)
    : handle_(std::fopen(file.c_str(), "ab")), file_(file) {
  if (!handle_) throw std::runtime_error(file.string() + ": cannot be written");
  std::fseek(handle_.get(), 0, SEEK_END);
  if (std::ftell(handle_.get()) == 0) append(Table(columns).text());
}

void TableFile::append(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), handle_.get()) == text.size();
  if (!written || std::fflush(handle_.get()) != 0) throw std::runtime_error(file_.string() + ": cannot be written");
}

}  // namespace echoway::report
