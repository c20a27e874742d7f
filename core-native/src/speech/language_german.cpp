#include "speech/language.hpp"

namespace echoway::speech {
namespace {

/// `last`: nothing follows the one ("eins"); else something does ("ein", "einundzwanzig").
std::string cardinal(int n, bool last) {
  static constexpr const char* kSmall[] = {
      "null", "ein", "zwei",  "drei",     "vier",     "fünf",     "sechs",    "sieben",   "acht",     "neun",
      "zehn", "elf", "zwölf", "dreizehn", "vierzehn", "fünfzehn", "sechzehn", "siebzehn", "achtzehn", "neunzehn"};
  static constexpr const char* kTens[] = {"",        "",        "zwanzig", "dreißig", "vierzig",
                                          "fünfzig", "sechzig", "siebzig", "achtzig", "neunzig"};
  if (n < 0 || n > 999) return std::to_string(n);
  if (n == 1) return last ? "eins" : "ein";
  if (n < 20) return kSmall[n];
  if (n < 100) {
    std::string words;
    if (n % 10 != 0) words.append(kSmall[n % 10]).append("und");
    return words.append(kTens[n / 10]);
  }
  std::string words = n < 200 ? "ein" : kSmall[n / 100];
  words += "hundert";
  if (n % 100 != 0) words += cardinal(n % 100, last);
  return words;
}

std::string number(int n) { return cardinal(n, true); }

}  // namespace

const LanguageTable& german() noexcept {
  static const LanguageTable table = {
      .tag = "de",
      .lines = {{
          "Halt.",
          "Hindernis {dir}[, {dist}].",
          "Position unsicher. Anhalten und langsam drehen.",
          "Langsam nach {side} drehen.",
          "Einen Schritt gehen: {dir}.",
          "Wieder {room}.",
          "Gürtel getrennt.",
          "Gürtel verbunden.",
          "Gürtelakku fast leer.",
          "Sensor {sensor} verdeckt.",
          "Falsche Richtung.",
          "Neuer Weg.",
          "Kein sicherer Weg dorthin.",
          "{turn}",
          "Etwas {side} halten.",
          "Geradeaus[, {dist}].",
          "Angekommen[: {what}][, {on}].",
          "Jetzt {what} {up}[ bis Ebene {level}].",
          "{room}.",
          "Vor Ihnen {what}[, {dist}].",
          "{what}[: {dist}].",
          "Tür {dir}[, {dist}].",
          "Treppe {up} {dir}[, {dist}].[ {stairs}.]",
          "Aufzug {dir}[, {dist}].",
          "Ausgang {dir}[, {dist}].",
          "{what} {dir}[, {dist}].",
          "Engstelle {dir}[, {dist}].",
          "{room}.",
      }},
      .directions = {{"voraus", "halb links", "halb rechts", "links", "rechts", "scharf links", "scharf rechts",
                      "hinter Ihnen"}},
      .turns = {{"Geradeaus.", "Halb links drehen.", "Halb rechts drehen.", "Links drehen.", "Rechts drehen.",
                 "Scharf links drehen.", "Scharf rechts drehen.", "Umdrehen."}},
      .on_side = {{"vor Ihnen", "links von Ihnen", "rechts von Ihnen", "links von Ihnen", "rechts von Ihnen",
                   "links von Ihnen", "rechts von Ihnen", "hinter Ihnen"}},
      .sensors = {{"vorne", "vorne links", "links", "hinten links", "hinten", "hinten rechts", "rechts",
                   "vorne rechts"}},
      .sides = {{"links", "rechts"}},
      .vague = {{"ein, zwei Schritte", "ein paar Schritte", "einige Schritte", "noch ein Stück"}},
      .clock = "auf {n} Uhr",
      .clock_one = "auf ein Uhr",
      .clock_twelve = "auf zwölf Uhr",
      .turn_clock = "Drehen {dir}.",
      .degrees = "{side}, {n} Grad",
      .turn_degrees = "{n} Grad nach {side} drehen.",
      .up = "aufwärts",
      .down = "abwärts",
      .foot = {"ein Fuß", "{n} Fuß", "ein halber Fuß", "anderthalb Fuß", "{n}einhalb Fuß"},
      .metre = {"ein Meter", "{n} Meter", "ein halber Meter", "anderthalb Meter", "{n}einhalb Meter"},
      .step = {"ein Schritt", "{n} Schritte", "ein halber Schritt", "anderthalb Schritte", "{n}einhalb Schritte"},
      .stair = {"eine Stufe", "{n} Stufen", "", "", ""},
      .room = "Raum {id}",
      .wall = "die Wand",
      .door = "die Tür",
      .stairs = "die Treppe",
      .elevator = "der Aufzug",
      .exit = "der Ausgang",
      .nowhere = "Ihr Ziel",
      .number = number,
      .is_singular = [](int halves) { return halves == 2; },
  };
  return table;
}

}  // namespace echoway::speech
