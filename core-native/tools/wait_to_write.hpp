#pragma once

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace echoway::tools {

/// Waits at most `patience` until `descriptor` takes more bytes; false when it does not or is broken. A signal
/// meanwhile (the window changes its size, the process goes on after a stop) says nothing of who reads: the wait goes
/// on with the time left.
[[nodiscard]] inline bool wait_to_write(int descriptor, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + patience;
  pollfd line{descriptor, POLLOUT, 0};
  auto left = patience;
  while (true) {
    const int ready = ::poll(&line, 1, static_cast<int>(left.count()));
    if (ready >= 0 || errno != EINTR) return ready > 0 && (line.revents & POLLOUT) != 0;
    left = std::max(std::chrono::milliseconds{0}, std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()));
  }
}

}  // namespace echoway::tools
