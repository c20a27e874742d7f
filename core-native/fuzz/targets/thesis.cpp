#include "session_calls.hpp"

namespace echoway::fuzz {

/// A session with the thesis's method. To open it costs as much as a hundred firings, hence many and no restart.
std::string thesis(Bytes data) {
  return drive_session(data, Method::thesis, {.calls = 400, .firings = 180, .restarts = 0});
}

}  // namespace echoway::fuzz
