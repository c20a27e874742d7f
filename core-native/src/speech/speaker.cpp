#include "echoway/speech/speaker.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "echoway/speech/room_name.hpp"
#include "speech/language.hpp"

namespace echoway {
namespace {

using speech::Counted;
using speech::LanguageTable;

const LanguageTable& table_of(Language language) {
  switch (language) {
    case Language::german:
      return speech::german();
    case Language::french:
      return speech::french();
    case Language::english:
      break;
  }
  return speech::english();
}

std::string with(std::string_view line, std::string_view key, std::string_view value) {
  std::string result(line);
  const auto at = result.find(key);
  if (at != std::string::npos) result.replace(at, key.size(), value);
  return result;
}

std::string counted(const LanguageTable& t, const Counted& noun, int halves) {
  const int whole = halves / 2;
  if (halves % 2 == 0) return t.is_singular(halves) ? noun.one : with(noun.other, "{n}", t.number(whole));
  if (whole == 0) return noun.half;
  return whole == 1 ? noun.one_half : with(noun.n_half, "{n}", t.number(whole));
}

std::size_t side_of(double direction) { return direction >= 0.0 ? 0 : 1; }

/// Degrees from the chest, rounded to the nearest ten, 0 ... 180.
int tens(double direction) { return 10 * static_cast<int>(std::lround(std::abs(to_degrees(direction)) / 10.0)); }

/// The nearest hour, 1 ... 12: hours go clockwise, directions counter-clockwise.
int hour(double direction) {
  const int h = static_cast<int>(std::lround(-to_degrees(direction) / 30.0));
  const int wrapped = ((h % 12) + 12) % 12;
  return wrapped == 0 ? 12 : wrapped;
}

/// Puts the parts of one cue into words; unless `named`, with one word in the place of each name of the building's.
class Line {
 public:
  Line(const Building& building, const SpeechStyle& style, const Cue& cue, bool named)
      : building_(building), style_(style), t_(table_of(style.language)), cue_(cue), named_(named) {}

  [[nodiscard]] std::string say(CueKind kind, double direction, double distance_m) const {
    return expand(kind, direction, distance_m);
  }

 private:
  /// Fills a template in; parts in brackets vanish with an empty placeholder in them.
  [[nodiscard]] std::string expand(CueKind kind, double direction, double distance_m) const {
    const std::string_view line = t_.lines[static_cast<std::size_t>(kind)];
    std::string result;
    std::string part;
    bool in_part = false;
    bool empty = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      std::string& out = in_part ? part : result;
      if (line[i] == '[') {
        in_part = true;
        empty = false;
        part.clear();
      } else if (line[i] == ']') {
        in_part = false;
        if (!empty) result += part;
      } else if (line[i] == '{') {
        const auto close = line.find('}', i);
        const std::string value = value_of(kind, line.substr(i + 1, close - i - 1), direction, distance_m);
        empty = empty || value.empty();
        out += value;
        i = close;
      } else {
        out += line[i];
      }
    }
    return result;
  }

  [[nodiscard]] std::string value_of(CueKind kind, std::string_view key, double direction, double distance_m) const {
    if (key == "dir") return where(direction);
    if (key == "turn") return turn(direction);
    if (key == "side") return t_.sides[side_of(direction)];
    if (key == "on") return cue_.has_direction ? on_side(direction) : "";
    if (key == "dist") return distance_m < 0.0 ? "" : length(distance_m);
    if (key == "what") return name(landmark(kind));
    if (key == "room") return name(room(cue_.room));
    if (key == "sensor") return t_.sensors[eighth(direction)];
    if (key == "up") return cue_.up ? t_.up : t_.down;
    if (key == "level") return level();
    if (key == "stairs") return cue_.count > 0 ? counted(t_, t_.stair, 2 * cue_.count) : "";
    return {};
  }

  [[nodiscard]] std::string name(const std::string& words) const { return named_ || words.empty() ? words : "name"; }

  [[nodiscard]] std::string where(double direction) const {
    if (style_.direction == DirectionStyle::clock) {
      const int h = hour(direction);
      if (h == 1) return t_.clock_one;
      return h == 12 ? t_.clock_twelve : with(t_.clock, "{n}", t_.number(h));
    }
    const Sector sector = sector_of(direction);
    const int ten = tens(direction);
    if (style_.direction == DirectionStyle::degrees && ten != 0 && ten != 180) return in_degrees(t_.degrees, direction);
    return t_.directions[static_cast<std::size_t>(sector)];
  }

  [[nodiscard]] std::string turn(double direction) const {
    const Sector sector = sector_of(direction);
    const bool plain = sector == Sector::ahead || sector == Sector::behind;
    if (plain || style_.direction == DirectionStyle::sides) return t_.turns[static_cast<std::size_t>(sector)];
    if (style_.direction == DirectionStyle::degrees) return in_degrees(t_.turn_degrees, direction);
    return with(with(t_.turn_clock, "{dir}", where(direction)), "{n}", t_.number(hour(direction)));
  }

  [[nodiscard]] std::string in_degrees(const char* line, double direction) const {
    return with(with(line, "{side}", t_.sides[side_of(direction)]), "{n}", t_.number(tens(direction)));
  }

  [[nodiscard]] std::string on_side(double direction) const {
    return t_.on_side[static_cast<std::size_t>(sector_of(direction))];
  }

  [[nodiscard]] static std::size_t eighth(double direction) {
    return static_cast<std::size_t>((std::lround(to_degrees(direction) / 45.0) % 8 + 8) % 8);
  }

  [[nodiscard]] std::string length(double metres) const {
    const SpokenLength spoken = spoken_length(metres, cue_.sigma_m, style_);
    if (spoken.vague) return t_.vague[static_cast<std::size_t>(spoken.vague_step)];
    const Counted& unit = style_.length == LengthStyle::feet     ? t_.foot
                          : style_.length == LengthStyle::metres ? t_.metre
                                                                 : t_.step;
    return counted(t_, unit, spoken.halves);
  }

  [[nodiscard]] std::string room(RoomIndex index) const {
    if (!building_.has_room(index)) return t_.nowhere;
    const RoomName called = room_name(building_.room(index));
    if (called.number.empty()) return called.name;
    std::string words = with(t_.room, "{id}", called.number);
    if (!called.name.empty() && called.name != words) words.append(", ").append(called.name);
    return words;
  }

  [[nodiscard]] std::string named(const std::vector<Landmark>& all, const char* fallback) const {
    const auto i = static_cast<std::size_t>(cue_.landmark.index);
    return i < all.size() && !all[i].name.empty() ? all[i].name : fallback;
  }

  [[nodiscard]] const LevelLink* link() const {
    const auto i = static_cast<std::size_t>(cue_.landmark.index);
    return cue_.landmark.kind == CueLandmark::Kind::link && i < building_.links.size() ? &building_.links[i] : nullptr;
  }

  [[nodiscard]] std::string landmark(CueKind kind) const {
    switch (cue_.landmark.kind) {
      case CueLandmark::Kind::door:
        return t_.door;
      case CueLandmark::Kind::link:
        return link() != nullptr && link()->kind == LevelLinkKind::elevator ? t_.elevator : t_.stairs;
      case CueLandmark::Kind::place:
        return named(building_.places, t_.nowhere);
      case CueLandmark::Kind::exit:
        return named(building_.exits, t_.exit);
      case CueLandmark::Kind::room:
        return room(cue_.landmark.index);
      case CueLandmark::Kind::none:
        break;
    }
    return kind == CueKind::facing ? t_.wall : "";
  }

  [[nodiscard]] std::string level() const {
    const LevelLink* l = link();
    if (l == nullptr || !building_.has_room(l->room_a) || !building_.has_room(l->room_b)) return {};
    const int a = building_.room(l->room_a).level;
    const int b = building_.room(l->room_b).level;
    if (a == b) return {};
    const int to = cue_.up ? std::max(a, b) : std::min(a, b);
    return to < 0 ? std::to_string(to) : t_.number(to);
  }

  const Building& building_;
  const SpeechStyle& style_;
  const LanguageTable& t_;
  const Cue& cue_;
  const bool named_;
};

// Words in a sentence; a name of the building's counts as one, however long it is.
constexpr int kMostWords = 8;

int words_of_longest_sentence(std::string_view line) {
  int longest = 0;
  int words = 0;
  while (!line.empty()) {
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(line.size(), word.size() + 1));
    if (word != ":") longest = std::max(longest, ++words);   // French writes a colon apart.
    if (word.ends_with('.')) words = 0;
  }
  return longest;
}

/// Where the line would be too long it tells the direction by its side; where it still is, it leaves the distance out.
std::string say_briefly(const Building& building, SpeechStyle style, const Cue& cue, CueTail fact) {
  const auto say = [&](bool named) {
    return Line(building, style, cue, named).say(fact.kind, fact.direction, fact.distance_m);
  };
  const auto is_too_long = [&] { return words_of_longest_sentence(say(false)) > kMostWords; };
  if (is_too_long()) style.direction = DirectionStyle::sides;
  if (is_too_long()) fact.distance_m = -1.0;
  return say(true);
}

/// Every sentence begins with a capital; names that begin beyond ASCII are left as they are.
void capitalise(std::string& line) {
  bool start = true;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (start && line[i] >= 'a' && line[i] <= 'z') line[i] = static_cast<char>(line[i] - 'a' + 'A');
    if (line[i] == ' ') continue;
    start = line[i] == '.' && i + 1 < line.size() && line[i + 1] == ' ';
  }
}

}  // namespace

Result<Language> language_of(std::string_view tag) {
  for (const Language language : {Language::english, Language::german, Language::french}) {
    const std::string_view known = tag_of(language);
    if (tag.size() < known.size()) continue;
    const bool same = (tag[0] | 0x20) == known[0] && (tag[1] | 0x20) == known[1];
    if (same && (tag.size() == 2 || tag[2] == '-' || tag[2] == '_')) return language;
  }
  return Error{std::string("no words for the language \"").append(tag).append("\"; there are en, de and fr")};
}

const char* tag_of(Language language) noexcept { return table_of(language).tag; }

std::string Speaker::say(const Cue& cue) const {
  std::string words = say_briefly(*building_, style_, cue, {cue.kind, true, cue.direction, cue.distance_m});
  if (cue.tail.present) words.append(" ").append(say_briefly(*building_, style_, cue, cue.tail));
  capitalise(words);
  return words;
}

}  // namespace echoway
