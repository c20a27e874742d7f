#include "building/folder.hpp"

#include <algorithm>
#include <system_error>

#include "text/utf8.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "room-";
constexpr std::string_view kSuffix = ".room";

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

std::string_view take_digits(std::string_view& s) {
  std::size_t n = 0;
  while (n < s.size() && is_digit(s[n])) ++n;
  std::string_view digits = s.substr(0, n);
  s.remove_prefix(n);
  const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
  digits.remove_prefix(zeros);
  return digits;
}

/// Order in which a person lists rooms: runs of digits by value, the rest by character.
bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view x = take_digits(a);
      const std::string_view y = take_digits(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

}  // namespace

std::string room_file_name(std::string_view id) {
  return std::string(kPrefix) + std::string(id) + std::string(kSuffix);
}

bool is_room_id(std::string_view id) noexcept {
  return !id.empty() && id.size() <= 200 && text::is_utf8(id) && std::none_of(id.begin(), id.end(), [](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == 0x7F || c == '#' || c == '"' || c == ',' || c == '/';
  });
}

std::vector<std::string> list_rooms(const fs::path& dir, Findings& findings) {
  std::vector<std::string> ids;
  std::error_code error;
  fs::directory_iterator it(dir, error);
  for (const fs::directory_iterator end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) continue;
    if (name.size() < kPrefix.size() + kSuffix.size()) continue;
    std::string id = name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
    std::error_code ignored;
    if (!is_room_id(id)) {
      findings.warn(Kind::room_id, text::to_utf8(it->path().string()), 0,
                    "is left out: a room's id must be a word without blanks, commas, quotes and #; rename the file");
    } else if (!it->is_regular_file(ignored)) {
      findings.unusable(Kind::unreadable, it->path().string(), 0, "is not a file");
    } else if (ids.size() == kMaxRooms) {
      findings.unusable(Kind::too_large, dir.string(), 0,
                        "has more than " + std::to_string(kMaxRooms) + " rooms; split the building");
      break;
    } else {
      ids.push_back(std::move(id));
    }
  }
  if (error) {
    findings.unusable(Kind::unreadable, dir.string(), 0, "cannot be read as a folder: " + error.message());
  } else if (ids.empty() && !findings.any_unusable()) {
    findings.unusable(Kind::no_rooms, dir.string(), 0,
                      "has no room files; a building needs at least one room-<id>.room");
  }
  std::sort(ids.begin(), ids.end(), natural_less);
  return ids;
}

}  // namespace echoway
