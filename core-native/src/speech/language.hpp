#pragma once

#include <array>
#include <string>

#include "echoway/guidance/cue.hpp"
#include "echoway/speech/speaker.hpp"

namespace echoway::speech {

/// A counted noun; `{n}` stands for the number in words.
struct Counted {
  const char* one;       ///< Exactly one.
  const char* other;     ///< Every other whole number.
  const char* half;      ///< One half.
  const char* one_half;  ///< One and a half.
  const char* n_half;    ///< `{n}` and a half.
};

/// Everything that a language needs to speak cues. A line is a template:
///   {dir} where it is        {turn} how to turn, a line   {side} left or right      {on} on which side of the wearer
///   {dist} how far           {what} the landmark          {room} the room           {sensor} which sensor
///   {up} up or down          {level} the floor's number   {stairs} steps of a flight
/// A part in [brackets] is left out when a placeholder in it has nothing to say.
struct LanguageTable {
  const char* tag;
  std::array<const char*, kCueKinds> lines;  ///< In the order of CueKind.
  std::array<const char*, 8> directions;     ///< By Sector: where something is.
  std::array<const char*, 8> turns;          ///< By Sector: a whole line for a turn that way.
  std::array<const char*, 8> on_side;        ///< By Sector: where an arrival lies.
  std::array<const char*, 8> sensors;        ///< From the front counter-clockwise, every 45 degrees.
  std::array<const char*, 2> sides;          ///< Left, right.
  std::array<const char*, 4> vague;          ///< By SpokenLength::vague_step.
  const char* clock;                         ///< Where: at {n} o'clock.
  const char* clock_one;                     ///< The same at one and at twelve, which some languages say differently.
  const char* clock_twelve;
  const char* turn_clock;                    ///< A whole line: turn to {dir} or {n}.
  const char* degrees;                       ///< Where: {side}, {n} degrees.
  const char* turn_degrees;                  ///< A whole line.
  const char* up;
  const char* down;
  Counted foot;
  Counted metre;
  Counted step;
  Counted stair;                             ///< Of a flight.
  const char* room;                          ///< With its {id}.
  const char* wall;
  const char* door;
  const char* stairs;
  const char* elevator;
  const char* exit;
  const char* nowhere;                       ///< A destination without a name.
  std::string (*number)(int);                ///< A cardinal in words, 0 ... 999; digits beyond.
  bool (*is_singular)(int halves);           ///< The language's plural rule (CLDR), by twice the number.
};

[[nodiscard]] const LanguageTable& english() noexcept;
[[nodiscard]] const LanguageTable& german() noexcept;
[[nodiscard]] const LanguageTable& french() noexcept;

}  // namespace echoway::speech
