#pragma once

#include <span>

#include "echoway/belt/belt.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// What a lost wearer is asked to do.
struct Probe {
  enum class Action : std::uint8_t { turn, step } action = Action::turn;
  double direction = kPi / 2;  ///< From the chest: the side to turn to, or the way to step.
  double disagreement = 0.0;   ///< Expected; 0 when no action in reach tells anything.
};

/// Of turning to either side and a step each way, the action after which the places that the wearer may be at are
/// expected to disagree most about the echoes: the sum over pairs of places of p_i p_j times the share of sensors whose
/// predicted ranges differ by more than the belt's noise. Steps that meet a wall in any likely place are left out.
/// Turning wins ties: it is safe.
[[nodiscard]] Probe choose_probe(const Router& router, const BeltConfig& belt, std::span<const Hypothesis> places);

}  // namespace echoway::guidance
