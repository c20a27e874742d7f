#include "console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

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

bool flush_output() noexcept {
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return true;
  complain(std::string("standard output: cannot be written: ") + std::strerror(errno));
  return false;
}

}  // namespace echoway::tools
