#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/session.hpp"
#include "left_out_table.hpp"
#include "option_checks.hpp"

namespace echoway::tools {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(Vec2 point) { return Json::array({point.x, point.y}); }

Json in_level(const Room& room, Vec2 point) { return to_json(room.frame.transform(point)); }

Json in_level(const Room& room, const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2 point : points) list.push_back(in_level(room, point));
  return list;
}

Json in_level(const Room& room, const std::vector<Segment>& segments) {
  Json list = Json::array();
  for (const Segment& s : segments) list.push_back(Json::array({in_level(room, s.a), in_level(room, s.b)}));
  return list;
}

Json describe(const Room& room) {
  Json boundary = Json::array();
  for (const std::vector<Vec2>& loop : room.boundary) boundary.push_back(in_level(room, loop));
  return {{"id", room.id},
          {"name", room.name},
          {"level", room.level},
          {"frame", {room.frame.position.x, room.frame.position.y, room.frame.heading}},
          {"walls", in_level(room, room.walls)},
          {"corners", in_level(room, room.corners)},
          {"edges", in_level(room, room.edges)},
          {"reflectors", in_level(room, room.reflectors)},
          {"boundary", std::move(boundary)}};
}

Json describe(const Landmark& landmark, const Building& building) {
  const Room& room = building.room(landmark.room);
  return {{"name", landmark.name}, {"room", room.id}, {"level", room.level}, {"at", in_level(room, landmark.at)}};
}

Json describe(const Door& door, const Building& building) {
  const Room& a = building.room(door.room_a);
  const Room& b = building.room(door.room_b);
  return {{"rooms", {a.id, b.id}},
          {"level", a.level},
          {"at", {in_level(a, door.at_a), in_level(b, door.at_b)}},
          {"width", door.width}};
}

Json describe(const LevelLink& link, const Building& building) {
  const Room& a = building.room(link.room_a);
  const Room& b = building.room(link.room_b);
  return {{"kind", link.kind == LevelLinkKind::stairs ? "stairs" : "elevator"},
          {"rooms", {a.id, b.id}},
          {"levels", {a.level, b.level}},
          {"at", {in_level(a, link.at_a), in_level(b, link.at_b)}}};
}

template <class Items, class... Context>
Json describe_all(const Items& items, const Context&... context) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(describe(item, context...));
  return list;
}

int describe_building(const std::string& dir) {
  const Result<Building> building = load_building(dir);
  if (!building) return bad_input(building.error());
  const Json all = {{"name", building->name},
                    {"rooms", describe_all(building->rooms)},
                    {"doors", describe_all(building->doors, *building)},
                    {"links", describe_all(building->links, *building)},
                    {"exits", describe_all(building->exits, *building)},
                    {"places", describe_all(building->places, *building)}};
  fmt::print("{}\n", all.dump(1, ' ', false, Json::error_handler_t::replace));
  return 0;
}

int describe_what_is_left_out(const std::string& dir) {
  const auto session = Session::open(dir, {});
  if (!session) return bad_input(session.error());
  fmt::print("{}", left_out_table((*session)->report_scene(), (*session)->building()));
  return 0;
}

}  // namespace

void add_describe(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("describe", "Print a building as JSON, for drawing and for other programs");
  command->footer("All places are in metres, in the frame of their level.");
  auto dir = std::make_shared<std::string>();
  command->add_option("DIR", *dir, "Building folder")->required()->check(not_empty());
  auto left_out = std::make_shared<bool>(false);
  command->add_flag("--left-out", *left_out,
                    "Print a table instead: what of the plan no echo in each room can\n"
                    "depend on, so that firings leave it out, and what that saves");
  command->callback(
      [dir, left_out, &status] { status = *left_out ? describe_what_is_left_out(*dir) : describe_building(*dir); });
}

}  // namespace echoway::tools
