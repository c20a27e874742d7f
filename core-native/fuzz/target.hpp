#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// What the fuzzers throw bytes at. The ordinary tests replay the corpus through the same functions, so a target must
/// not depend on libFuzzer.
namespace echoway::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct Target {
  std::string_view name;  ///< Also of its folders under corpus/ and regressions/.
  /// Empty when every promise was kept, else which was broken. A refusal of the input is a kept promise.
  std::string (*run)(Bytes);
};

std::string building(Bytes data);
std::string import_osm(Bytes data);
std::string import_wrld(Bytes data);
std::string import_imdf(Bytes data);
std::string import_drawn(Bytes data);
std::string sentences(Bytes data);
std::string belt(Bytes data);
std::string scan_log(Bytes data);
std::string motion_log(Bytes data);
std::string track_log(Bytes data);
std::string session(Bytes data);
std::string thesis(Bytes data);
std::string guidance(Bytes data);
std::string tracker(Bytes data);
std::string jni_layouts(Bytes data);
/// Only where a JDK's headers were found.
std::string jni_calls(Bytes data);

[[nodiscard]] std::span<const Target> targets();

}  // namespace echoway::fuzz
