#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "report/table_file.hpp"
#include "support/blind_walk.hpp"

namespace echoway::proof {

/// Which walk it is.
struct WalkName {
  std::string map;
  std::string source;
  std::uint64_t seed = 0;
};

inline constexpr std::string_view kTraceColumns = "map,source,walk,kind,x_m,y_m,level,text";

/// The walls of a building, and a walk through it with its things, lines and shortest way, as rows for the picture.
void draw_walls(const std::string& map, const Router& router, report::TableFile& out);
void draw_walk(const WalkName& walk, const Building& building, const Route& way, test::PoseSource& poses,
               const test::WalkOutcome& o, report::TableFile& out);

}  // namespace echoway::proof
