#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "echoway/session.hpp"
#include "echoway/speech/speaker.hpp"

namespace echoway::tools {

struct SpokenCue {
  double time_s = 0.0;
  std::string kind;
  std::string text;
};

/// Takes the cues of a session and puts them into words. Two cues may have the same words (a turn and a sharper one "to
/// four o'clock"): the second is left out within the session's repeat_gap_s(), as in the app.
class CueCollector {
 public:
  CueCollector(Session& session, const SpeechStyle& style) : session_(session), speaker_(session.building(), style) {}

  /// Takes what is there to be spoken; returns how many cues that was.
  std::size_t collect();
  [[nodiscard]] const std::vector<SpokenCue>& cues() const { return cues_; }

 private:
  [[nodiscard]] bool said_lately(const SpokenCue& cue) const;

  Session& session_;
  Speaker speaker_;
  std::vector<SpokenCue> cues_;
};

/// `text` as a CSV field: in quotes, inner quotes doubled.
std::string csv_quoted(std::string_view text);

}  // namespace echoway::tools
