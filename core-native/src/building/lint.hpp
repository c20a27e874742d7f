#pragma once

#include "building/assembly.hpp"
#include "building/findings.hpp"

namespace echoway {

// What `echoway check` warns of. All of it leaves the building usable, so that loading does without.

/// Walls, corners and edges of each room by itself.
void lint_rooms(const Assembly& assembly, Findings& findings);

/// Sizes that suggest a wrong unit.
void lint_sizes(const Assembly& assembly, Findings& findings);

/// Doors. REQUIRES: a usable building.
void lint_doors(const Assembly& assembly, Findings& findings);

/// How rooms lie on their levels and whether one can walk to them. REQUIRES: a usable building.
void lint_levels(const Assembly& assembly, Findings& findings);

/// Names, places, exits, stairs. REQUIRES: a usable building.
void lint_landmarks(const Assembly& assembly, Findings& findings);

}  // namespace echoway
