#include <cmath>

#include "echoway/io/logs.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

std::string check_belt(const BeltHeader& header) {
  const BeltConfig belt = header.apply_to({});
  if (belt.sensors < 1 || belt.sensors > kMaxSensors) return "sensor count out of range";
  for (const double value : {belt.radius_m, belt.beam_rad, belt.slot_s}) {
    if (!std::isfinite(value)) return "the belt's header is not finite";
  }
  return "";
}

std::string check(const ScanLog& log) {
  double last = -INFINITY;
  const int sensors = log.belt.apply_to({}).sensors;
  for (const Firing& f : log.firings) {
    if (!std::isfinite(f.time_s) || !std::isfinite(f.range_m)) return "a firing is not finite";
    if (f.time_s < last) return "firings out of order";
    if (f.sensor < 0 || f.sensor >= sensors) return "sensor out of range";
    if (f.range_m < 0.0 && f.range_m != Firing::kNoEcho) return "negative range";
    last = f.time_s;
  }
  return check_belt(log.belt);
}

}  // namespace

std::string scan_log(Bytes data) {
  const MemoryFile file(data);
  const Result<ScanLog> log = read_scan_log(file.path());
  if (!log) return log.error().message.empty() ? "an error without words" : "";
  return check(*log);
}

}  // namespace echoway::fuzz
