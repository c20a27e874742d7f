#include "cue_collector.hpp"

namespace echoway::tools {

std::size_t CueCollector::collect() {
  const std::size_t before = cues_.size();
  Cue cue;
  while (session_.next_cue(cue)) cues_.push_back({cue.time_s, to_string(cue.kind), speaker_.say(cue)});
  return cues_.size() - before;
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
