#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "belt_time.hpp"
#include "echoway/session.hpp"

namespace echoway::tools {

/// Hands what a live belt sends to a session, each sentence at the time at which BeltTime says that it arrived.
class LiveBelt {
 public:
  /// `host_s` tells the host's time, seconds since the start, and never goes back; `on_news` is called whenever the
  /// session may have something to say. The session must outlive it.
  LiveBelt(Session& session, std::function<double()> host_s, std::function<void()> on_news);

  /// `on_news` waits for the first sentence or tick.
  void attach();
  void detach();
  /// Time passes, whether or not the belt sends.
  void tick();
  /// What was read at once.
  void take(std::span<const std::uint8_t> bytes);

 private:
  [[nodiscard]] double now() { return time_.tell(host_s_()); }

  Session& session_;
  std::function<double()> host_s_;
  std::function<void()> on_news_;
  BeltTime time_;
};

}  // namespace echoway::tools
