#pragma once

#include "echoway/import/projection.hpp"
#include "source/plan.hpp"

namespace echoway::import {

/// Takes a plan's degrees to metres around the middle of the building, in place, and cleans its rings: repeated points
/// go, rings without area go, features that lie kilometres away go. All of it is reported. Throws SourceError when
/// nothing is left or the plan is larger than any building.
LocalProjection project_plan(Plan& plan, Report& report);

}  // namespace echoway::import
