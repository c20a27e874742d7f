#include "source/osm_tags.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace echoway::import {

std::string tag(const OsmTags& tags, std::string_view key) {
  const auto found = tags.find(key);
  return found == tags.end() ? std::string() : found->second;
}

bool has(const OsmTags& tags, std::string_view key) { return tags.find(key) != tags.end(); }

double metres(const std::string& text) {
  char* rest = nullptr;
  const double value = std::strtod(text.c_str(), &rest);
  if (rest == text.c_str() || !std::isfinite(value) || value <= 0.0) return 0.0;
  std::string unit(rest);
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  if (unit.empty() || unit == "m") return value;
  if (unit == "cm") return value * 0.01;
  return 0.0;
}

bool is_indoor(const OsmTags& tags) {
  return has(tags, "indoor") || (has(tags, "level") && (has(tags, "highway") || has(tags, "stairs")));
}

bool is_entrance(const OsmTags& tags) { return has(tags, "entrance") && tag(tags, "entrance") != "no"; }

bool is_door(const OsmTags& tags) {
  return is_entrance(tags) || (has(tags, "door") && tag(tags, "door") != "no") || tag(tags, "indoor") == "door";
}

UnitKind unit_kind(const OsmTags& tags) {
  const std::string indoor = tag(tags, "indoor");
  if (tag(tags, "stairs") == "yes" || tag(tags, "room") == "stairs" || has(tags, "conveying")) return UnitKind::stairs;
  if (tag(tags, "highway") == "elevator" || tag(tags, "room") == "elevator") return UnitKind::elevator;
  if (indoor == "room") return UnitKind::room;
  return UnitKind::open;
}

std::string category_of(const OsmTags& tags) {
  for (const char* key : {"room", "amenity", "shop", "office", "tourism", "leisure", "healthcare", "emergency"}) {
    const std::string value = tag(tags, key);
    if (!value.empty() && value != "yes") return value;
  }
  return tag(tags, "indoor");
}

bool says_no_more(const OsmTags& way, const OsmTags& relation) {
  constexpr std::array kWhatItIs{"indoor", "level", "repeat_on", "name", "ref"};
  const auto repeated = [&](const char* key) { return !has(way, key) || tag(way, key) == tag(relation, key); };
  return unit_kind(way) == unit_kind(relation) && std::all_of(kWhatItIs.begin(), kWhatItIs.end(), repeated);
}

}  // namespace echoway::import
