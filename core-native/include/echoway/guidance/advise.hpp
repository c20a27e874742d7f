#pragma once

#include "echoway/guidance/guide.hpp"
#include "echoway/locate/locator.hpp"

namespace echoway {

/// Tells the locator what the guide knows of the wearer's way: whether they are led, what they were told to take, and
/// whether there is cause to doubt where they are thought to be. To be called after every estimate; returns whether
/// there is.
bool advise(Locator& locator, Guide& guide);

}  // namespace echoway
