// One libFuzzer executable a target; ECHOWAY_FUZZ_TARGET names it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "target.hpp"

/// GEOS 3.11 loses what it has built of a buffer when it finds that it must begin again on a grid. Its stacks cannot be
/// told apart: it is built without frame pointers.
extern "C" const char* __lsan_default_suppressions() { return "leak:libgeos.so"; }

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
