#pragma once

#include <string>

#include "echoway/guidance/guide.hpp"
#include "echoway/session.hpp"

namespace echoway::plans {

/// Which promise of a session's output is broken: something not finite, out of range or contradictory. Empty when none
/// is.
[[nodiscard]] std::string broken_promise(const Session& session);
[[nodiscard]] std::string broken_promise(const Locator& locator, const Building& building);
[[nodiscard]] std::string broken_health(const BeltHealth& health);
/// The same for cues (all that wait are taken), the route, breadcrumbs and obstacles.
[[nodiscard]] std::string broken_guidance(Session& session);
[[nodiscard]] std::string broken_guidance(Guide& guide, const Building& building);
/// The same for the explained scan.
[[nodiscard]] std::string broken_explanation(Session& session);

}  // namespace echoway::plans
