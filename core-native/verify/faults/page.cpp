#include <cstdio>

#include "faults/fault.hpp"

namespace echoway::faults {
namespace {

std::string fixed(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// The first lines, each with its delay.
std::string describe_heard(const Report& result) {
  constexpr std::size_t kMost = 4;
  if (result.heard.empty()) return "nothing";
  std::string text;
  for (std::size_t i = 0; i < result.heard.size() && i < kMost; ++i) {
    if (i > 0) text += "; ";
    text += "\"" + result.heard[i].words + "\" after " + fixed(result.heard[i].after_s, 1) + " s";
  }
  if (result.heard.size() > kMost) text += "; " + std::to_string(result.heard.size() - kMost) + " more";
  return text;
}

}  // namespace

std::string page() {
  std::string text =
      "# Faults\n\nWritten by `make faults-page` from the faults that the tests inject (core-native/verify/faults) "
      "into the bytes of a simulated\nwalk of a minute through three rooms. A fault that does not last throughout "
      "begins after 15 s; \"after\" counts from there, so\na line of a fault that lasts throughout may come before. "
      "What is heard is what belt health and track state call for, in the\nwords of the speech tables.\n\n"
      "| fault | the wearer hears | firings lost | taken but never sent | last estimate off by | verdict |\n"
      "|---|---|---|---|---|---|\n";
  for (const Fault& fault : table()) {
    const Report result = run(fault);
    const std::string why = verdict(fault, result);
    text += "| " + fault.name + " | " + describe_heard(result) + " | " + std::to_string(result.sent - result.taken) +
            " of " + std::to_string(result.sent) + " | " + std::to_string(result.invented) + " | " +
            fixed(result.error_m, 2) + " m | " + (why.empty() ? "holds" : "**fails**: " + why) + " |\n";
  }
  text +=
      "\nFiles: a log is written beside its place and renamed when it is whole, so a full disk leaves nothing "
      "half-written and\nthe file that was there before stays as it was; a log that was cut at any byte is read up to "
      "its last whole row\n(core-native/test/verify/test_faults.cpp).\n";
  return text;
}

}  // namespace echoway::faults
