#pragma once

#include <memory>

#include "echoway/locate/locator.hpp"
#include "echoway/result.hpp"
#include "echoway/session.hpp"

namespace echoway {

/// The locator that `config.method` names. `building` must outlive it. REQUIRES: a checked configuration.
Result<std::unique_ptr<Locator>> make_locator(const Building& building, const SessionConfig& config);

}  // namespace echoway
