#pragma once

#include <functional>
#include <string>

#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"

namespace echoway::stiff {

/// A simulated wearer walking through plans::three_rooms(), and a session that follows.
struct Wearer {
  Building building;
  sim::Simulation walk;
  SessionConfig config;      ///< Start known, unless a case changes that.
};

/// The same wearer every time. `belt`: worn and expected.
[[nodiscard]] Wearer wearer(double duration_s, const BeltConfig& belt = {});

/// What following the walk came to.
struct Followed {
  std::string broken;        ///< First broken promise; empty when all were kept.
  Estimate last{};
  double error_m = 0.0;      ///< Of the last estimate, in the level's frame.
  int false_certainties = 0; ///< Estimates said to be tracking, yet more than 5 sigma and 1 m off.
  int estimates = 0;
};

/// Changes an input before the session gets it.
using ChangeFiring = std::function<Firing(Firing, int index)>;
using ChangeHint = std::function<MotionHint(MotionHint, int index)>;

/// Feeds the walk, each input changed; checks every promise after each. `before`: what the session goes through first,
/// at times before 0.
[[nodiscard]] Followed follow(const Wearer& wearer, const ChangeFiring& change_firing = nullptr,
                              const ChangeHint& change_hint = nullptr,
                              const std::function<void(Session&)>& before = nullptr);

}  // namespace echoway::stiff
