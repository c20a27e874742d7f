#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "await_reading.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "echoway/belt/sentence.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/units.hpp"
#include "option_checks.hpp"
#include "wait_to_write.hpp"

namespace echoway::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStatusPeriod = 1.0;  // Seconds of the log between the belt's words about itself.
constexpr double kLongestFlightUs = 1e6;  // That a sentence holds (docs/wire-protocol.md).
constexpr double kLongestWaitS = 1e9;     // Clocks count no farther than centuries.

struct PlayOptions {
  std::string scans;
  double speed = 1.0;
  double patience_s = 30.0;
};

/// The belt's end of a pseudo-terminal; the listener opens name().
class BeltTerminal {
 public:
  BeltTerminal() : descriptor_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0 || grantpt(descriptor_) != 0 || unlockpt(descriptor_) != 0) return;
    const char* name = ptsname(descriptor_);
    if (name != nullptr) name_ = name;
    // Held open, so that sentences sent before a listener comes are kept rather than lost with a hang-up.
    listener_side_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    if (tcgetattr(listener_side_, &settings) == 0) {
      cfmakeraw(&settings);
      tcsetattr(listener_side_, TCSANOW, &settings);
    }
  }
  BeltTerminal(const BeltTerminal&) = delete;
  BeltTerminal& operator=(const BeltTerminal&) = delete;
  ~BeltTerminal() {
    if (listener_side_ >= 0) ::close(listener_side_);
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// False when the line holds no more of it and nobody reads for so long.
  [[nodiscard]] bool send(std::string_view sentence, std::chrono::milliseconds patience) const {
    while (!sentence.empty()) {
      const ssize_t count = ::write(descriptor_, sentence.data(), sentence.size());
      if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
      if (count > 0) sentence.remove_prefix(static_cast<std::size_t>(count));
      if (!sentence.empty() && !wait_to_write(descriptor_, patience)) return false;
    }
    return true;
  }
  /// How many bytes wait for a listener: hanging up would lose them.
  [[nodiscard]] int unread() const {
    // What a busy machine has not carried over the line yet is not counted; asking whether there is something to read
    // has it carried over.
    pollfd listener{listener_side_, POLLIN, 0};
    ::poll(&listener, 1, 0);
    int bytes = 0;
    return ioctl(listener_side_, FIONREAD, &bytes) == 0 ? bytes : 0;
  }

 private:
  int descriptor_ = -1;
  int listener_side_ = -1;
  std::string name_;
};

/// The firing as the belt sends it: a time of flight in whole microseconds. What takes longer than any belt listens is
/// no echo.
EncodedSentence to_sentence(std::uint16_t seq, const Firing& firing, double sound_speed_mps) {
  EchoSentence echo{seq, static_cast<std::uint8_t>(firing.sensor), std::nullopt};
  const double flight_us = 2e6 * firing.range_m / sound_speed_mps;
  if (firing.has_echo() && flight_us < kLongestFlightUs) {
    echo.tof_us = static_cast<std::uint32_t>(std::lround(flight_us));
  }
  return encode(echo);
}

StatusSentence status_of(const BeltHeader& belt) {
  StatusSentence status;
  status.sensors = belt.apply_to({}).sensors;
  if (belt.temperature_c) status.temperature_dc = static_cast<int>(std::lround(10.0 * *belt.temperature_c));
  return status;
}

int play(const PlayOptions& options) {
  const Result<ScanLog> log = read_scan_log(options.scans);
  if (!log) return bad_input(log.error());
  const BeltTerminal terminal;
  if (terminal.name().empty()) return bad_input({"no pseudo-terminal can be had here"});
  fmt::print("{}\n", terminal.name());
  std::fflush(stdout);

  const auto begin = Clock::now();
  const double first = log->firings.empty() ? 0.0 : log->firings.front().time_s;
  const double sound_speed = speed_of_sound(BeltConfig{}.temperature_c);
  const EncodedSentence status = encode(status_of(log->belt));
  const std::chrono::milliseconds patience{std::lround(1e3 * options.patience_s)};
  double status_due = first;
  std::uint16_t seq = 0;
  for (const Firing& firing : log->firings) {
    const std::chrono::duration<double> due{std::min((firing.time_s - first) / options.speed, kLongestWaitS)};
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(due));
    bool sent = true;
    if (firing.time_s >= status_due) {
      sent = terminal.send(status.text(), patience);
      status_due += kStatusPeriod * (1.0 + std::floor((firing.time_s - status_due) / kStatusPeriod));
    }
    sent = sent && terminal.send(to_sentence(seq++, firing, sound_speed).text(), patience);
    if (!sent) return bad_input({"nobody reads the terminal", terminal.name()});
  }
  RealTime time;
  const bool all_read = await_reading([&terminal] { return terminal.unread(); }, time, patience);
  return all_read ? 0 : bad_input({"nobody reads the terminal", terminal.name()});
}

}  // namespace

void add_play(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("play", "Play a scan log as a belt on a new pseudo-terminal and print its name");
  auto options = std::make_shared<PlayOptions>();
  command->add_option("--scans", options->scans, "Scan log (*.scans.csv)")->required()->check(not_empty());
  command->add_option("--speed", options->speed, "How many times as fast as it was recorded")
      ->check(decimal(0.01, 1000.0))
      ->capture_default_str();
  command
      ->add_option("--patience", options->patience_s,
                   "Seconds to wait for a reader, when the line is full and at the end")
      ->check(decimal(0.0, 86400.0))
      ->capture_default_str();
  command->callback([options, &status] { status = play(*options); });
}

}  // namespace echoway::tools
