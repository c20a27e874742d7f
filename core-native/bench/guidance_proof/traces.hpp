#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "support/blind_walk.hpp"

namespace echoway::proof {

/// Which walk it is.
struct WalkName {
  std::string map;
  std::string source;
  std::uint64_t seed = 0;
};

/// The walls of a building, and a walk through it with its things, lines and shortest way, as rows for the picture.
void draw_walls(const std::string& map, const Router& router, std::FILE* out);
void draw_walk(const WalkName& walk, const Building& building, const Route& way, test::PoseSource& poses,
               const test::WalkOutcome& o, std::FILE* out);

}  // namespace echoway::proof
