#include "session_calls.hpp"

namespace echoway::fuzz {

/// Few firings: one costs as much as all other calls together. What many of them do to a tracker is the target
/// `tracker`'s business.
std::string session(Bytes data) {
  return drive_session(data, Method::bayes, {.calls = 150, .firings = 16, .restarts = 1});
}

}  // namespace echoway::fuzz
