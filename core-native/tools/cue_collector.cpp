#include "cue_collector.hpp"

#include <algorithm>
#include <utility>

namespace echoway::tools {

std::size_t CueCollector::collect() {
  const std::size_t before = cues_.size();
  Cue cue;
  while (session_.next_cue(cue)) {
    SpokenCue spoken{cue.time_s, to_string(cue.kind), speaker_.say(cue)};
    if (!said_lately(spoken)) cues_.push_back(std::move(spoken));
  }
  return cues_.size() - before;
}

bool CueCollector::said_lately(const SpokenCue& cue) const {
  const double since = cue.time_s - session_.repeat_gap_s();
  const auto old =
      std::find_if(cues_.rbegin(), cues_.rend(), [since](const SpokenCue& said) { return said.time_s <= since; });
  return std::any_of(cues_.rbegin(), old, [&cue](const SpokenCue& said) { return said.text == cue.text; });
}

std::string csv_quoted(std::string_view text) {
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += c;
    field += c;
  }
  return field + '"';
}

}  // namespace echoway::tools
