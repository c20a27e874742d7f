#include <string>

#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Without the blanks around it, ASCII letters in lower case.
std::string folded(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  const auto last = text.find_last_not_of(" \t\r\n");
  std::string result;
  for (const char c : text.substr(first, last - first + 1)) result += lower(c);
  return result;
}

void list(std::string& names, const std::string& name) {
  if (name.empty()) return;
  names += names.empty() ? "" : ", ";
  names += '"' + name + '"';
}

}  // namespace

Result<Goal> Router::find_goal(std::string_view text) const {
  const std::string wanted = folded(text);
  if (wanted.empty()) return Error{"the destination is empty"};
  const auto find = [&](const std::vector<Landmark>& all, Goal::Kind kind, Goal& goal) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (folded(all[i].name) != wanted) continue;
      goal = {kind, static_cast<std::int32_t>(i), {}};
      return true;
    }
    return false;
  };
  Goal goal;
  if (find(building_->places, Goal::Kind::place, goal) || find(building_->exits, Goal::Kind::exit, goal)) return goal;
  for (std::size_t r = 0; r < building_->rooms.size(); ++r) {
    const Room& room = building_->rooms[r];
    const std::string id = folded(room.id);
    if (wanted == id || wanted == "room " + id || wanted == folded(room.name)) {
      return Goal{Goal::Kind::room, static_cast<std::int32_t>(r), {}};
    }
  }
  if (wanted == "exit" || wanted == "nearest exit" || wanted == "way out") {
    return Goal{Goal::Kind::nearest_exit, -1, {}};
  }
  std::string names;
  for (const Landmark& place : building_->places) list(names, place.name);
  for (const Landmark& exit : building_->exits) list(names, exit.name);
  return Error{"nothing here is called \"" + std::string(text) + "\"; say a room's id, \"exit\"" +
               (names.empty() ? "" : " or one of " + names)};
}

}  // namespace echoway
