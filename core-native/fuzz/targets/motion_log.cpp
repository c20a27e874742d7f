#include <cmath>

#include "echoway/io/logs.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {

std::string motion_log(Bytes data) {
  const MemoryFile file(data);
  const Result<std::vector<MotionHint>> hints = read_motion_log(file.path());
  if (!hints) return hints.error().message.empty() ? "an error without words" : "";
  double last = -INFINITY;
  for (const MotionHint& hint : *hints) {
    if (!std::isfinite(hint.time_s) || !std::isfinite(hint.value)) return "a hint is not finite";
    if (hint.time_s < last) return "hints out of order";
    last = hint.time_s;
  }
  return "";
}

}  // namespace echoway::fuzz
