#include "echoway/speech/room_name.hpp"

#include <algorithm>
#include <string_view>

namespace echoway {
namespace {

/// Letters and figures only, in lower case.
std::string letters_of(const std::string& text) {
  std::string letters;
  for (const char c : text) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
  }
  return letters.empty() ? text : letters;
}

/// The number alone of a room that the importer called by level and number ("2-room-7"); any other id as it is.
std::string_view number_in(std::string_view id) {
  constexpr std::string_view kNumbered = "-room-";
  const auto at = id.rfind(kNumbered);
  if (at == std::string_view::npos) return id;
  const std::string_view number = id.substr(at + kNumbered.size());
  const bool figures = number.find_first_not_of("0123456789-") == std::string_view::npos;
  return figures && !number.empty() ? number : id;
}

/// "2.07" or "B 12": what stands on a door, and no word.
bool is_door_number(std::string_view name) {
  const auto is_figure = [](unsigned char c) { return c >= '0' && c <= '9'; };
  const auto is_letter = [](unsigned char c) { return (c | 0x20) >= 'a' && ((c | 0x20) <= 'z' || c >= 0x80); };
  const auto word = std::ranges::adjacent_find(name, [&](char a, char b) { return is_letter(a) && is_letter(b); });
  return word == name.end() && std::ranges::any_of(name, is_figure);
}

}  // namespace

RoomName room_name(const Room& room) {
  const bool of_the_name = !room.name.empty() && letters_of(room.id).find(letters_of(room.name)) != std::string::npos;
  if (!of_the_name) return {std::string(number_in(room.id)), room.name};
  return is_door_number(room.name) ? RoomName{room.name, {}} : RoomName{{}, room.name};
}

}  // namespace echoway
