#include "console.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "echoway/io/atomic_file.hpp"

namespace echoway::tools {

// Not fmt::print(), which throws where nothing can be written.
void complain(const std::string& line) noexcept {
  std::fputs(line.c_str(), stderr);
  std::fputc('\n', stderr);
}

int bad_input(const Error& error) noexcept {
  complain(error.to_string());
  return kBadInput;
}

std::FILE* words_beside(std::initializer_list<std::string_view> files) {
  const bool taken =
      std::ranges::any_of(files, [](std::string_view file) { return descriptor_named_by(file) == STDOUT_FILENO; });
  return taken ? stderr : stdout;
}

bool flush_output() noexcept {
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return true;
  complain(std::string("standard output: cannot be written: ") + std::strerror(errno));
  return false;
}

}  // namespace echoway::tools
