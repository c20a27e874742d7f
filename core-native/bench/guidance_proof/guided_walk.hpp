#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "echoway/routing/router.hpp"
#include "report/table_file.hpp"

namespace echoway::proof {

inline constexpr std::string_view kWalkColumns =
    "map,source,walk,arrived,time_s,walked_m,shortest_m,touches,wrong,instructions,cues,end_error_m,track_error_m,"
    "room_right,bumps,wrong_place,leading,barred";

struct Files {
  report::TableFile rows;
  report::TableFile traces;
  bool diary = false;  ///< On the standard output.
};

/// Lets walk `seed` of a building happen, with the positions of `source` (see main.cpp), and writes down what became of
/// it.
void walk(const std::string& name, const Router& router, const std::string& source, std::uint64_t seed, Files& out);

}  // namespace echoway::proof
