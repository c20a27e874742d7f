#pragma once

#include <string>

#include "echoway/session.hpp"
#include "target.hpp"

namespace echoway::fuzz {

/// How far one input may go: what it may still spend.
struct Allowance {
  int calls = 0;
  int firings = 0;
  int restarts = 0;  ///< Each makes a locator anew.
};

/// Opens a session as the input says and makes the calls that it says, in its order, checking every promise after each.
std::string drive_session(Bytes data, Method method, Allowance left);

}  // namespace echoway::fuzz
