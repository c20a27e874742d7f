// One libFuzzer executable a target; ECHOWAY_FUZZ_TARGET names it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const echoway::fuzz::Target& target : echoway::fuzz::targets()) {
    if (target.name != ECHOWAY_FUZZ_TARGET) continue;
    const std::string broken = target.run({data, size});
    if (broken.empty()) return 0;
    std::fprintf(stderr, "promise broken: %s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
