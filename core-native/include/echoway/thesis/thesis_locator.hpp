#pragma once

#include <memory>

#include "echoway/building/building.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/result.hpp"
#include "echoway/thesis/parameters.hpp"

namespace echoway {

/// The thesis's method (chapter 5): every two passes of the belt are averaged into a scan, the scan is matched with
/// what the belt would read at postulated poses, and the best match is the estimate; rooms next door are tried near an
/// exit. See docs/thesis-method.md for what the thesis leaves open.
///
/// - estimate() is renewed once a scan; its time is the mean time of the scan's firings, the moment that it is about.
/// - With room, position and heading given it tracks from the first scan on, as the thesis does. Otherwise it first
///   searches what is left open, up to the whole building, and says `searching` until one place stands out.
/// - Motion hints are ignored: the thesis uses none. A temperature rescales the ranges.
/// - It reports no sensor suspicions. Sensors that say nothing are left out of the match.
///
/// What it needs of `building` is copied. Fails when the belt or the start makes no sense: sensors outside
/// 1 ... kMaxSensors, anything not finite, a start where nobody can stand (see check_start()).
Result<std::unique_ptr<Locator>> make_thesis_locator(const Building& building, const BeltConfig& belt,
                                                     const Start& start, const ThesisParameters& parameters = {});

}  // namespace echoway
