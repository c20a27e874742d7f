#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "echoway/routing/router.hpp"

namespace echoway::proof {

struct Files {
  std::FILE* rows;
  std::FILE* traces;
  bool diary = false;  ///< On the standard output.
};

/// Lets walk `seed` of a building happen, with the positions of `source` (see main.cpp), and writes down what became of it.
void walk(const std::string& name, const Router& router, const std::string& source, std::uint64_t seed, Files out);

}  // namespace echoway::proof
