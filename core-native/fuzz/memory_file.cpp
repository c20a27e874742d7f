#include "memory_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <string>

namespace echoway::fuzz {

MemoryFile::MemoryFile(std::span<const std::uint8_t> bytes)
    : descriptor_(::memfd_create("echoway", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ::ssize_t n = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (n <= 0) break;
    written += static_cast<std::size_t>(n);
  }
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

}  // namespace echoway::fuzz
