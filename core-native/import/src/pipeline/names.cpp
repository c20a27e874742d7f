#include "pipeline/names.hpp"

#include <array>
#include <cctype>
#include <utility>

#include "source/limits.hpp"

namespace echoway::import {
namespace {

constexpr std::size_t kMaxSlug = 40;

// Plain letters for U+00C0 to U+017F, the Latin letters with accents.
constexpr std::string_view kPlainLatin =
    "aaaaaaaceeeeiiiidnooooo-ouuuuytsaaaaaaaceeeeiiiidnooooo-ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnn"
    "oooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

struct Decoded {
  unsigned code = 0;
  std::size_t length = 0;  ///< 0: not UTF-8.
};

Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 && lead < 0xF5   ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                                                           : 0;
  if (length == 0 || text.size() < length) return {};
  unsigned code = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  constexpr std::array<unsigned, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[length] || surrogate || code > 0x10FFFF ? Decoded{} : Decoded{code, length};
}

char plain(unsigned code) {
  if (code < 0x80) return static_cast<char>(std::tolower(static_cast<int>(code)));
  if (code >= 0xC0 && code - 0xC0 < kPlainLatin.size()) return kPlainLatin[code - 0xC0];
  return '\0';
}

}  // namespace

std::string slug(std::string_view name) {
  std::string out;
  while (!name.empty() && out.size() < kMaxSlug) {
    const Decoded d = decode(name);
    name.remove_prefix(d.length == 0 ? 1 : d.length);
    const char c = d.length == 0 ? '\0' : plain(d.code);
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      out += c;
    } else if (c == '.' && !out.empty() && !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
      out += c;  // room number 2.14
    } else if (c != '\'' && c != '\0' && !out.empty() && out.back() != '-') {
      out += '-';
    }
  }
  while (!out.empty() && (out.back() == '-' || out.back() == '.')) out.pop_back();
  return out;
}

std::string clean_name(std::string_view name) {
  std::string out;
  while (!name.empty()) {
    const Decoded d = decode(name);
    const std::size_t length = d.length == 0 ? 1 : d.length;
    if (out.size() + length > kMaxNameLength) break;
    if (d.length == 0) {
      out += '?';
    } else if (d.code < 0x20 || d.code == 0x7F || d.code == ' ') {
      if (!out.empty() && out.back() != ' ') out += ' ';
    } else if (d.code == '"') {
      out += '\'';
    } else {
      out += name.substr(0, length);
    }
    name.remove_prefix(length);
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::string spoken_category(std::string_view category) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kSpoken{{
      {"restroom.female", "Women's toilet"}, {"restroom.male", "Men's toilet"},
      {"restroom.wheelchair", "Accessible toilet"}, {"restroom.unisex.wheelchair", "Accessible toilet"},
      {"restroom.family", "Family toilet"}, {"restroom", "Toilet"}, {"bathroom", "Toilet"}, {"toilets", "Toilet"},
      {"toilet", "Toilet"}, {"stairs", "Stairs"}, {"steps", "Steps"}, {"escalator", "Escalator"}, {"ramp", "Ramp"},
      {"movingwalkway", "Moving walkway"}, {"elevator", "Elevator"}, {"conferenceroom", "Meeting room"},
      {"huddleroom", "Meeting room"}, {"phoneroom", "Phone room"}, {"mothersroom", "Nursing room"},
      {"firstaid", "First aid"}, {"serverroom", "Server room"}, {"waitingroom", "Waiting room"},
      {"mailroom", "Mail room"}, {"foodservice", "Cafeteria"}, {"privatelounge", "Lounge"},
      {"movietheater", "Cinema"}, {"fitnessroom", "Fitness room"}, {"hallway", "Corridor"}, {"corridor", "Corridor"},
      {"information", "Information desk"}, {"atm", "Cash machine"}, {"aed", "Defibrillator"},
      {"drinkingfountain", "Drinking fountain"}, {"drinking_water", "Drinking water"},
  }};
  static constexpr std::array<std::string_view, 13> kSilent{
      "room",      "area", "unit", "walkway", "unspecified", "no_geometry", "nonpublic",
      "structure", "yes",  "wall", "column",  "level",       "door"};
  for (const auto& [word, spoken] : kSpoken) {
    if (category == word) return std::string(spoken);
  }
  for (const std::string_view word : kSilent) {
    if (category == word || category.substr(0, category.find('.')) == word) return {};
  }
  const std::size_t dot = category.find('.');
  if (dot != std::string_view::npos) {
    if (const std::string general = spoken_category(category.substr(0, dot)); !general.empty()) return general;
  }
  std::string words = clean_name(category.substr(0, dot));
  for (char& c : words) c = c == '_' ? ' ' : c;
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string unique_id(const std::string& wanted, std::set<std::string>& taken) {
  std::string id = wanted;
  for (int n = 2; !taken.insert(id).second; ++n) id = wanted + "-" + std::to_string(n);
  return id;
}

}  // namespace echoway::import
