#pragma once

#include <string>

#include "echoway/session.hpp"

namespace echoway::plans {

/// Which promise of a session's output is broken: something not finite, out of range or contradictory. Empty when none is.
[[nodiscard]] std::string broken_promise(const Session& session);

}  // namespace echoway::plans
