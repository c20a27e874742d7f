#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "source/plan.hpp"

namespace echoway::import {

/// JSON of bounded depth and size; throws SourceError with file and line.
[[nodiscard]] nlohmann::json parse_json(const std::string& text, const std::string& file);

/// The members of a FeatureCollection; throws SourceError when `document` is none or holds too many.
[[nodiscard]] const nlohmann::json& features_of(const nlohmann::json& document, const std::string& file);

/// A GeoJSON geometry, sorted by dimension. Coordinates are degrees as given.
struct Geometry {
  Area areas;
  std::vector<Path> paths;
  std::vector<Vec2> points;
};

/// Throws SourceError when a coordinate is no longitude and latitude; other faults (rings of fewer than three points,
/// unknown kinds) leave the geometry empty.
[[nodiscard]] Geometry read_geometry(const nlohmann::json& feature, const Source& source);

/// Text of a member that may be a string, a number, null or absent.
[[nodiscard]] std::string text_of(const nlohmann::json& object, const char* key);
/// A whole number of a level, however it is written (2, 2.0); nothing for other values and beyond kMaxLevels.
[[nodiscard]] std::optional<int> level_number(const nlohmann::json& value);
/// An object's member, or null.
[[nodiscard]] const nlohmann::json& member(const nlohmann::json& object, const char* key);

/// Adds a pair of degrees to a path after checking that it lies on the earth; throws SourceError.
void append_checked(Path& path, double lon, double lat, const Source& source);

}  // namespace echoway::import
