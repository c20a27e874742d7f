#include "source/geojson.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "source/limits.hpp"
#include "source/source_error.hpp"

namespace echoway::import {
namespace {

using nlohmann::json;

int line_at(const std::string& text, std::size_t byte) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(
                                                                          std::min(byte, text.size())), '\n'));
}

struct TooMuch {
  const char* what;
};

// By the mark that it begins with.
bool is_utf16(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

Vec2 read_position(const json& j, const Source& source) {
  if (!j.is_array() || j.size() < 2 || !j[0].is_number() || !j[1].is_number()) {
    throw SourceError(source, "a coordinate is not a pair of numbers");
  }
  Path checked;
  append_checked(checked, j[0].get<double>(), j[1].get<double>(), source);
  return checked.front();
}

Path read_path(const json& j, const Source& source) {
  Path path;
  if (!j.is_array()) throw SourceError(source, "coordinates are not an array");
  for (const json& position : j) path.push_back(read_position(position, source));
  return path;
}

Path read_ring(const json& j, const Source& source) {
  Path ring = read_path(j, source);
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

void read_polygon(const json& j, const Source& source, Area& into) {
  if (!j.is_array()) throw SourceError(source, "coordinates are not an array");
  geos::Polygon2 polygon;
  for (const json& r : j) {
    Path ring = read_ring(r, source);
    (polygon.outer.empty() ? polygon.outer : polygon.holes.emplace_back()) = std::move(ring);
  }
  if (!polygon.outer.empty()) into.push_back(std::move(polygon));
}

void read_into(const json& geometry, const Source& source, Geometry& into) {
  const std::string type = text_of(geometry, "type");
  const json& c = member(geometry, "coordinates");
  if (type == "Point") into.points.push_back(read_position(c, source));
  if (type == "LineString") into.paths.push_back(read_path(c, source));
  if (type == "Polygon") read_polygon(c, source, into.areas);
  const bool multiple = type == "MultiPoint" || type == "MultiLineString" || type == "MultiPolygon";
  if (multiple && !c.is_array()) throw SourceError(source, "coordinates are not an array");
  if (!multiple) return;
  for (const json& part : c) {
    if (type == "MultiPoint") into.points.push_back(read_position(part, source));
    if (type == "MultiLineString") into.paths.push_back(read_path(part, source));
    if (type == "MultiPolygon") read_polygon(part, source, into.areas);
  }
}

}  // namespace

json parse_json(const std::string& text, const std::string& file) {
  std::size_t values = 0;
  const auto guard = [&values](int depth, json::parse_event_t, json&) {
    if (depth > kMaxNesting) throw TooMuch{"is nested too deeply for a floor plan"};
    if (++values > kMaxJsonValues) throw TooMuch{"holds too many values for a floor plan"};
    return true;
  };
  try {
    return json::parse(text, guard);
  } catch (const TooMuch& too) {
    throw SourceError(Error{too.what, file, 0});
  } catch (const json::parse_error& e) {
    const bool encoded =
        std::string_view(e.what()).find("ill-formed UTF-8") != std::string_view::npos || is_utf16(text);
    const char* what = encoded ? "is not UTF-8 text: save the plan in UTF-8" : "is not JSON: unexpected text here";
    throw SourceError(Error{what, file, line_at(text, e.byte)});
  } catch (const json::exception& e) {
    // A number out of double's range, such as 1e999, ends here.
    throw SourceError(Error{std::string("is not usable JSON: ") + e.what(), file, 0});
  }
}

const json& features_of(const json& document, const std::string& file) {
  const json& features = member(document, "features");
  if (!features.is_array()) throw SourceError(Error{"is not a GeoJSON FeatureCollection", file, 0});
  if (features.size() > kMaxFeatures) throw SourceError(Error{"holds too many features for a floor plan", file, 0});
  return features;
}

Geometry read_geometry(const json& feature, const Source& source) {
  Geometry into;
  const json& geometry = member(feature, "geometry");
  if (text_of(geometry, "type") == "GeometryCollection" && member(geometry, "geometries").is_array()) {
    for (const json& part : member(geometry, "geometries")) read_into(part, source, into);
  } else if (geometry.is_object()) {
    read_into(geometry, source, into);
  }
  return into;
}

std::string text_of(const json& object, const char* key) {
  const json& value = member(object, key);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.dump();
  return {};
}

std::optional<int> level_number(const json& value) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (number != std::floor(number) || std::abs(number) > kMaxLevels) return std::nullopt;
  return static_cast<int>(number);
}

const json& member(const json& object, const char* key) {
  static const json kNull;
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

void append_checked(Path& path, double lon, double lat, const Source& source) {
  if (!std::isfinite(lon) || !std::isfinite(lat)) throw SourceError(source, "a coordinate is not a finite number");
  if (std::abs(lon) > 180.0 || std::abs(lat) >= 90.0) {
    throw SourceError(source, "a coordinate is no longitude and latitude in degrees (WGS 84): export the plan in it");
  }
  path.push_back({lon, lat});
}

}  // namespace echoway::import
