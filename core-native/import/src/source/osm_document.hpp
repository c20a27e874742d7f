#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "echoway/geometry/vec2.hpp"

namespace echoway::import {

using OsmId = std::int64_t;
using OsmTags = std::map<std::string, std::string, std::less<>>;

struct OsmNode {
  Vec2 at{};  ///< Degrees.
  int line = 0;
  OsmTags tags;
};

struct OsmWay {
  std::vector<OsmId> nodes;
  int line = 0;
  OsmTags tags;
};

struct OsmMember {
  std::string type;
  OsmId ref = 0;
  std::string role;
};

struct OsmRelation {
  std::vector<OsmMember> members;
  int line = 0;
  OsmTags tags;
};

/// An OpenStreetMap XML file as it stands, version 0.6.
struct OsmDocument {
  std::string file;
  std::map<OsmId, OsmNode> nodes;
  std::map<OsmId, OsmWay> ways;
  std::map<OsmId, OsmRelation> relations;
};

/// Throws SourceError with file and line for what is not well-formed, declares entities, or breaks a limit.
[[nodiscard]] OsmDocument read_osm_document(const std::filesystem::path& path);

}  // namespace echoway::import
