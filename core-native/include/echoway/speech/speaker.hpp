#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "echoway/building/building.hpp"
#include "echoway/guidance/cue.hpp"
#include "echoway/result.hpp"

namespace echoway {

enum class Language : std::uint8_t { english, german, french };
enum class DirectionStyle : std::uint8_t {
  sides,    ///< "slightly left", "behind you".
  clock,    ///< "at two o'clock", the nearest hour.
  degrees,  ///< "left, forty degrees", the nearest ten.
};
enum class LengthStyle : std::uint8_t { feet, metres, steps };

struct SpeechStyle {
  Language language = Language::english;
  DirectionStyle direction = DirectionStyle::sides;
  LengthStyle length = LengthStyle::feet;
  double step_length_m = 0.65;  ///< For LengthStyle::steps; 0.3 ... 1.2.
};

/// The language of a BCP 47 tag ("en", "de-AT"); fails with the languages that there are.
[[nodiscard]] Result<Language> language_of(std::string_view tag);
/// The tag by which a speech engine is asked for a voice.
[[nodiscard]] const char* tag_of(Language language) noexcept;

/// A length as it is spoken: never more precise than it is known.
struct SpokenLength {
  bool vague = false;
  int vague_step = 0;   ///< When vague: 0 a step or two, 1 a few steps, 2 several steps, 3 further.
  int halves = 0;       ///< When not: twice the number of units (metres come in halves).
};
/// Rounds to 1 ft below 10 ft and to 5 ft above; to 0.5 m below 3 m and to 1 m above; to whole steps, and to 5 from 10.
/// A standard deviation `sigma_m` that this grain does not cover makes it coarser, and from 0.75 m on the length vague.
[[nodiscard]] SpokenLength spoken_length(double metres, double sigma_m, const SpeechStyle& style) noexcept;

/// Puts cues into words: one table a language, the rules of docs/guidance.md.
class Speaker {
 public:
  /// REQUIRES: the building outlives the speaker.
  explicit Speaker(const Building& building, const SpeechStyle& style = {}) : building_(&building), style_(style) {}

  [[nodiscard]] const SpeechStyle& style() const noexcept { return style_; }

  /// The line for `cue`, UTF-8, with its full stop. Never empty.
  [[nodiscard]] std::string say(const Cue& cue) const;

 private:
  const Building* building_;
  SpeechStyle style_;
};

}  // namespace echoway
