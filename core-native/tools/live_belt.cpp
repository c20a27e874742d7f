#include "live_belt.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace echoway::tools {

LiveBelt::LiveBelt(Session& session, std::function<double()> host_s, std::function<void()> on_news)
    : session_(session),
      host_s_(std::move(host_s)),
      on_news_(std::move(on_news)),
      time_(session.config().belt.slot_s) {}

void LiveBelt::attach() { session_.on_belt_attached(now()); }

void LiveBelt::detach() {
  session_.on_belt_detached(now());
  on_news_();
}

void LiveBelt::tick() {
  session_.on_tick(now());
  on_news_();
}

// Sentence by sentence, for each may have arrived at another time.
void LiveBelt::take(std::span<const std::uint8_t> bytes) {
  time_.on_read(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '$')), host_s_());
  while (!bytes.empty()) {
    const auto end = static_cast<std::size_t>(std::find(bytes.begin() + 1, bytes.end(), '$') - bytes.begin());
    const std::uint64_t lost = session_.belt_health().lost_firings;
    const double arrival = time_.next();
    const int firings = session_.on_bytes(bytes.first(end), arrival);
    time_.on_firings(firings, session_.belt_health().lost_firings - lost, host_s_());
    session_.on_tick(arrival);
    on_news_();
    bytes = bytes.subspan(end);
  }
}

}  // namespace echoway::tools
