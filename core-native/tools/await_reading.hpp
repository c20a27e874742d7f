#pragma once

#include <chrono>
#include <thread>

namespace echoway::tools {

/// The machine's own clock, for await_reading().
struct RealTime {
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] static Clock::time_point now() { return Clock::now(); }
  static void sleep(std::chrono::milliseconds time) { std::this_thread::sleep_for(time); }
};

/// Between two looks at what waits for a listener.
inline constexpr std::chrono::milliseconds kLinger{500};

/// Waits for a listener that still reads, for they would lose the end to the hang-up; false when they read nothing for
/// `patience`. `unread()` is how many bytes wait for them: a line may show what it holds bit by bit, so that nothing
/// waits counts only when it is seen twice.
template <class Unread, class Time>
[[nodiscard]] bool await_reading(const Unread& unread, Time& time, std::chrono::milliseconds patience) {
  auto last_read = time.now();
  int before = unread();
  while (true) {
    time.sleep(kLinger);
    const int waits = unread();
    if (waits == 0 && before == 0) return true;
    if (waits != before) last_read = time.now();
    if (time.now() - last_read >= patience) return false;
    before = waits;
  }
}

}  // namespace echoway::tools
