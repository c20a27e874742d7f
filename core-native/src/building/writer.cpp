#include "echoway/building/writer.hpp"

#include <cmath>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "building/folder.hpp"
#include "building/source.hpp"
#include "echoway/io/atomic_file.hpp"
#include "text/format.hpp"
#include "echoway/text/tokens.hpp"

namespace echoway {
namespace {

namespace fs = std::filesystem;

constexpr int kLengthDecimals = 4;
constexpr int kAngleDecimals = 6;

class Lines {
 public:
  explicit Lines(LengthUnit unit) : per_metre_(1.0 / metres_per(unit)) {}

  Lines& word(std::string_view word) {
    if (!text_.empty() && text_.back() != '\n') text_ += ' ';
    text_ += word;
    return *this;
  }
  Lines& count(std::size_t n) { return word(std::to_string(n)); }
  Lines& length(double metres) { return number(metres * per_metre_, kLengthDecimals); }
  Lines& point(Vec2 p) { return length(p.x).length(p.y); }
  Lines& number(double value, int decimals) {
    bad_ |= !text::is_writable(value);
    std::string digits;
    text::append_number(digits, value, decimals);
    return word(digits);
  }
  Lines& end() {
    text_ += '\n';
    return *this;
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool bad() const { return bad_; }

 private:
  double per_metre_;
  std::string text_;
  bool bad_ = false;
};

void write_room(const Room& room, Lines& out) {
  out.count(room.walls.size()).count(room.corners.size()).count(room.edges.size());
  if (!room.reflectors.empty()) out.count(room.reflectors.size());
  out.end();
  for (const Segment& wall : room.walls) out.word("1").point(wall.a).point(wall.b).end();
  for (const Vec2 corner : room.corners) out.word("2").point(corner).end();
  for (const Vec2 edge : room.edges) out.word("3").point(edge).end();
  for (const Segment& reflector : room.reflectors) out.word("4").point(reflector.a).point(reflector.b).end();
}

void write_config(const Building& building, Lines& out) {
  const auto id = [&](RoomIndex room) -> const std::string& { return building.room(room).id; };
  out.word("units").word(building.unit == LengthUnit::feet ? "ft" : "m").end();
  if (!building.name.empty()) out.word("name").word(text::quote(building.name)).end();
  for (const Room& room : building.rooms) {
    if (room.level == 0 && room.name.empty()) continue;
    out.word("room").word(room.id).word("level").word(std::to_string(room.level));
    if (!room.name.empty()) out.word(text::quote(room.name));
    out.end();
  }
  for (const Room& room : building.rooms) {
    if (building.rooms.size() == 1 && room.frame == Pose2{}) continue;
    out.word("frame").word(room.id).point(room.frame.position);
    out.number(to_degrees(room.frame.heading), kAngleDecimals).end();
  }
  for (const Door& door : building.doors) {
    out.word("door").word(id(door.room_a)).point(door.at_a).word(id(door.room_b)).point(door.at_b);
    out.word("width").length(door.width).end();
  }
  for (const LevelLink& link : building.links) {
    out.word(link.kind == LevelLinkKind::stairs ? "stairs" : "elevator");
    out.word(id(link.room_a)).point(link.at_a).word(id(link.room_b)).point(link.at_b).end();
  }
  for (const Landmark& exit : building.exits) {
    out.word("exit").word(id(exit.room)).point(exit.at);
    if (!exit.name.empty()) out.word(text::quote(exit.name));
    out.end();
  }
  for (const Landmark& place : building.places) {
    out.word("place").word(id(place.room)).point(place.at).word(text::quote(place.name)).end();
  }
}

std::optional<std::string> why_not_writable(const Building& building) {
  std::set<std::string_view> ids;
  for (const Room& room : building.rooms) {
    if (!is_room_id(room.id)) return "room id '" + room.id + "' is no word that a file can name";
    if (!ids.insert(room.id).second) return "two rooms are called '" + room.id + "'";
  }
  for (const Door& door : building.doors) {
    if (!building.has_room(door.room_a) || !building.has_room(door.room_b)) {
      return "a door leads to a room that does not exist";
    }
  }
  for (const LevelLink& link : building.links) {
    if (!building.has_room(link.room_a) || !building.has_room(link.room_b)) {
      return "stairs lead to a room that does not exist";
    }
  }
  for (const auto* list : {&building.exits, &building.places}) {
    for (const Landmark& landmark : *list) {
      if (!building.has_room(landmark.room)) return "a place is in a room that does not exist";
    }
  }
  return std::nullopt;
}

/// A room file that is not of this building would be read back as part of it.
std::optional<fs::path> stale_room_file(const Building& building, const fs::path& dir) {
  std::set<std::string> ours;
  for (const Room& room : building.rooms) ours.insert(room_file_name(room.id));
  std::error_code error;
  for (fs::directory_iterator it(dir, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with("room-") && name.ends_with(".room") && !ours.contains(name)) return it->path();
  }
  return std::nullopt;
}

Status prepare(std::vector<AtomicFile>& files, const fs::path& path, const Lines& lines) {
  if (lines.bad()) return Error{"not written: a number is not finite or too large", path.string()};
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  file->write(lines.text());
  if (Status closed = file->close(); !closed) return closed;
  files.push_back(std::move(file).value());
  return success();
}

}  // namespace

Status write_building(const Building& building, const fs::path& dir) {
  if (const auto problem = why_not_writable(building)) return Error{"not written: " + *problem, dir.string()};
  std::error_code error;
  std::error_code ignored;
  fs::create_directories(dir, error);
  if (!fs::is_directory(dir, ignored)) {
    if (fs::exists(dir, ignored)) return Error{"is a file, not a folder", dir.string()};
    return Error{"cannot be made a folder: " + error.message(), dir.string()};
  }
  if (const auto stale = stale_room_file(building, dir)) {
    return Error{"is not part of this building; remove it or choose an empty folder", stale->string()};
  }
  std::vector<AtomicFile> files;
  for (const Room& room : building.rooms) {
    Lines lines(building.unit);
    write_room(room, lines);
    if (Status status = prepare(files, dir / room_file_name(room.id), lines); !status) return status;
  }
  Lines lines(building.unit);
  write_config(building, lines);
  if (Status status = prepare(files, dir / kConfigName, lines); !status) return status;
  for (AtomicFile& file : files) {
    if (Status status = file.commit(); !status) return status;
  }
  return success();
}

}  // namespace echoway
