#include <fmt/format.h>

#include <array>
#include <string_view>

#include "drawn_plans.hpp"

namespace echoway::fuzz {
namespace {

std::string positions(Reader& in, bool ring) {
  std::string text;
  std::string first;
  for (int left = 1 + in.byte() % 8; left >= 0; --left) {
    const Spot s = take_spot(in);
    const std::string at = fmt::format("[{:.9f},{:.9f}]", s.lon, s.lat);
    if (first.empty()) first = at;
    text += at + ",";
  }
  if (ring) return "[" + text + first + "]";
  text.pop_back();
  return "[" + text + "]";
}

std::string geometry(Reader& in, std::string_view type) {
  if (type == "Point") {
    const Spot s = take_spot(in);
    return fmt::format(R"({{"type":"Point","coordinates":[{:.9f},{:.9f}]}})", s.lon, s.lat);
  }
  if (type == "LineString") return R"({"type":"LineString","coordinates":)" + positions(in, false) + "}";
  std::string rings = positions(in, true);
  if (in.byte() < 32) rings += "," + positions(in, true);
  return R"({"type":"Polygon","coordinates":[)" + rings + "]}";
}

void write_collection(const plans::ScratchFolder& folder, const std::string& name, std::string features) {
  if (!features.empty()) features.pop_back();  // the last comma
  folder.write(name, R"({"type":"FeatureCollection","features":[)" + features + "]}");
}

std::string relationship(Reader& in) {
  const int from = in.byte() % kMostFeatures;
  const int to = in.byte() % kMostFeatures;
  return fmt::format(R"({{"properties":{{"category":"stairs","origin":{{"id":"{}"}},"destination":{{"id":"{}"}}}}}},)",
                     from, to);
}

}  // namespace

void draw_wrld(Reader& in, const plans::ScratchFolder& folder) {
  static constexpr std::array<std::string_view, 14> kTypes{
      "building_outline", "wall",     "wall",   "wall",          "door",   "door",   "unit",
      "room",             "hallway",  "stairs", "elevator",      "window", "garden", "floor_opening"};
  std::array<std::string, 3> levels;
  std::string links;
  for (int i = 0; i < kMostFeatures && !in.empty(); ++i) {
    const std::uint8_t where = in.byte();
    if (where < 16) {
      const int from = in.byte() % 3;
      const int to = in.byte() % 3;
      links += fmt::format(R"({{"levels":[{},{}],"properties":{{"type":"stairs"}},"geometry":{}}},)", from, to,
                           geometry(in, "LineString"));
      continue;
    }
    const std::string_view type = one_of(in, kTypes);
    levels[where % 3] += fmt::format(R"({{"properties":{{"id":{},"type":"{}","name":"{}"}},"geometry":{}}},)", i, type,
                                     where % 5, geometry(in, "Polygon"));
  }
  folder.write("main.json", R"({"levels":[{"z_order":0,"filename":"0"},{"z_order":1,"filename":"1"},)"
                            R"({"z_order":2,"filename":"2"}]})");
  for (std::size_t i = 0; i < levels.size(); ++i) write_collection(folder, std::to_string(i), levels[i]);
  write_collection(folder, "main-paths.json", links);
}

void draw_imdf(Reader& in, const plans::ScratchFolder& folder) {
  static constexpr std::array<std::string_view, 9> kUnits{"room",  "walkway", "stairs",      "elevator", "column",
                                                          "lobby", "terrace", "opentobelow", "restroom"};
  static constexpr std::array<std::string_view, 3> kOpenings{"pedestrian", "pedestrian.principal", "emergencyexit"};
  static constexpr std::array<std::string_view, 2> kFixtures{"wall", "furniture"};
  std::string units, openings, fixtures, amenities, relationships;
  for (int i = 0; i < kMostFeatures && !in.empty(); ++i) {
    const std::uint8_t what = in.byte();
    const int level = what % 2;
    const auto feature = [&](std::string_view category, std::string_view type) {
      return fmt::format(R"({{"id":"{}","properties":{{"level_id":"{}","category":"{}","unit_ids":["{}"]}},)"
                         R"("geometry":{}}},)", i, level, category, i / 2, geometry(in, type));
    };
    if (what < 128) units += feature(one_of(in, kUnits), "Polygon");
    else if (what < 208) openings += feature(one_of(in, kOpenings), "LineString");
    else if (what < 228) fixtures += feature(one_of(in, kFixtures), "Polygon");
    else if (what < 240) amenities += feature("atm", "Point");
    else relationships += relationship(in);
  }
  folder.write("manifest.json", R"({"version":"1.0.0"})");
  write_collection(folder, "level.geojson",
                   R"({"id":"0","properties":{"ordinal":0}},{"id":"1","properties":{"ordinal":1}},)");
  write_collection(folder, "unit.geojson", units);
  write_collection(folder, "opening.geojson", openings);
  write_collection(folder, "fixture.geojson", fixtures);
  write_collection(folder, "amenity.geojson", amenities);
  write_collection(folder, "relationship.geojson", relationships);
}

}  // namespace echoway::fuzz
