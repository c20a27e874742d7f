#include "echoway/sim/walk.hpp"

#include <utility>

namespace echoway::sim {

void Walk::add(Action action, int line) { steps.push_back({std::move(action), line}); }

}  // namespace echoway::sim
