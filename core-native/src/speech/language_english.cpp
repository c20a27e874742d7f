#include "speech/language.hpp"

namespace echoway::speech {
namespace {

std::string number(int n) {
  static constexpr const char* kSmall[] = {
      "zero", "one",    "two",    "three",    "four",     "five",    "six",     "seven",     "eight",    "nine",
      "ten",  "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
  static constexpr const char* kTens[] = {"",      "",      "twenty",  "thirty", "forty",
                                          "fifty", "sixty", "seventy", "eighty", "ninety"};
  if (n < 0 || n > 999) return std::to_string(n);
  if (n < 20) return kSmall[n];
  if (n < 100) {
    std::string words = kTens[n / 10];
    if (n % 10 != 0) words.append("-").append(kSmall[n % 10]);
    return words;
  }
  std::string words = kSmall[n / 100];
  words += " hundred";
  if (n % 100 != 0) words.append(" ").append(number(n % 100));
  return words;
}

}  // namespace

const LanguageTable& english() noexcept {
  static const LanguageTable table = {
      .tag = "en",
      .lines = {{
          "Stop.",
          "Something {dir}[, {dist}].",
          "Not sure where you are. Stop and turn slowly.",
          "Turn slowly {side}.",
          "Take one step {dir}.",
          "{room} again.",
          "Belt disconnected.",
          "Belt connected.",
          "Belt battery low.",
          "{sensor} sensor blocked.",
          "Wrong way.",
          "New route.",
          "No safe way there.",
          "{turn}",
          "Bear {side}.",
          "Go straight[, {dist}].",
          "Arrived[: {what}][, {on}].",
          "Take {what} {up}[ to level {level}].",
          "{room}.",
          "Facing {what}[, {dist}].",
          "{what}[: {dist}].",
          "Door {dir}[, {dist}].",
          "Stairs {up} {dir}[, {dist}].[ {stairs}.]",
          "Elevator {dir}[, {dist}].",
          "Exit {dir}[, {dist}].",
          "{what} {dir}[, {dist}].",
          "Narrow passage {dir}[, {dist}].",
          "{room}.",
      }},
      .directions = {{"ahead", "slightly left", "slightly right", "left", "right", "sharp left", "sharp right",
                      "behind you"}},
      .turns = {{"Go straight.", "Turn slightly left.", "Turn slightly right.", "Turn left.", "Turn right.",
                 "Turn sharp left.", "Turn sharp right.", "Turn around."}},
      .on_side = {{"ahead of you", "on your left", "on your right", "on your left", "on your right", "on your left",
                   "on your right", "behind you"}},
      .sensors = {{"Front", "Front left", "Left", "Back left", "Back", "Back right", "Right", "Front right"}},
      .sides = {{"left", "right"}},
      .vague = {{"a step or two", "a few steps", "several steps", "some way"}},
      .clock = "at {n} o'clock",
      .clock_one = "at one o'clock",
      .clock_twelve = "at twelve o'clock",
      .turn_clock = "Turn to {n} o'clock.",
      .degrees = "{side}, {n} degrees",
      .turn_degrees = "Turn {side}, {n} degrees.",
      .up = "up",
      .down = "down",
      .foot = {"one foot", "{n} feet", "half a foot", "one and a half feet", "{n} and a half feet"},
      .metre = {"one metre", "{n} metres", "half a metre", "one and a half metres", "{n} and a half metres"},
      .step = {"one step", "{n} steps", "half a step", "one and a half steps", "{n} and a half steps"},
      .stair = {"one step", "{n} steps", "", "", ""},
      .room = "Room {id}",
      .wall = "the wall",
      .door = "the door",
      .stairs = "the stairs",
      .elevator = "the elevator",
      .exit = "the exit",
      .nowhere = "your destination",
      .number = number,
      .is_singular = [](int halves) { return halves == 2; },
  };
  return table;
}

}  // namespace echoway::speech
