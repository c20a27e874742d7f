#pragma once

#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Whether an estimate says a place at all: a room of the building and a finite pose in it.
[[nodiscard]] bool is_place(const Building& building, const Estimate& estimate) noexcept;

/// Metres that somebody has to go at least to get from one place to another: straight within a room, else over a door
/// that joins the two; infinite where none does. REQUIRES: both are places.
[[nodiscard]] double least_walk(const Router& router, const Estimate& from, const Estimate& to) noexcept;

}  // namespace echoway::guidance
