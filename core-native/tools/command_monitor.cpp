#include <fmt/core.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/building/loader.hpp"
#include "live_belt.hpp"
#include "live_report.hpp"
#include "option_checks.hpp"
#include "serial_port.hpp"
#include "session_options.hpp"

namespace echoway::tools {
namespace {

using Clock = std::chrono::steady_clock;

// Often enough to notice a silent belt within two seconds.
constexpr int kTickMs = 250;
// As much as Linux keeps of a line that is not read: what waited is read in one go, and tells how fast it came.
constexpr std::size_t kLineHolds = 4096;
// A belt that was pulled out is waited for this long before the command ends.
constexpr std::chrono::seconds kReturnWait{5};
// Where pseudo-terminals are: the name of one that hung up is given to the next that any program asks for.
constexpr std::string_view kPseudoTerminals = "/dev/pts/";

std::atomic<bool> interrupted{false};

void interrupt(int) { interrupted = true; }

struct MonitorOptions {
  SessionOptions session;
  std::string port;
  int baud = 38400;
};

class Monitor {
 public:
  Monitor(Session& session, const MonitorOptions& options)
      : session_(session),
        options_(options),
        report_(session, options.session.speech_style()),
        belt_(session, [this] { return host_time(); }, [this] { report_.update(); }) {}

  int run() {
    Result<SerialPort> port = SerialPort::open(options_.port, options_.baud);
    if (!port) return bad_input(port.error());
    std::optional<SerialPort> line(std::move(*port));
    while (line && !interrupted) {
      belt_.attach();
      listen(*line);
      if (const std::optional<Error> other = other_belt()) return bad_input(*other);
      line.reset();
      belt_.detach();
      report_.print_belt();
      if (!interrupted) line = wait_for_return();
    }
    return 0;
  }

 private:
  [[nodiscard]] double host_time() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  void listen(SerialPort& line) {
    std::array<std::uint8_t, kLineHolds> buffer{};
    while (!interrupted) {
      const SerialPort::Read read = line.read(buffer, kTickMs);
      if (read.outcome == SerialPort::Outcome::closed) return;
      belt_.take(std::span(buffer).first(read.count));
      if (other_belt()) return;
      belt_.tick();
    }
  }

  /// Sensors of a belt that has more or fewer of them look elsewhere than is thought. What --sensors says holds.
  [[nodiscard]] std::optional<Error> other_belt() const {
    const int said = session_.belt_health().sensor_count;
    const int thought = session_.config().belt.sensors;
    if (options_.session.sensors || said == thought) return std::nullopt;
    return Error{fmt::format("the belt says that it has {} sensors, not {}; give --sensors {}", said, thought, said),
                 options_.port};
  }

  std::optional<SerialPort> wait_for_return() {
    const bool may_return = !options_.port.starts_with(kPseudoTerminals);
    const auto give_up = Clock::now() + kReturnWait;
    while (!interrupted && Clock::now() < give_up) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kTickMs));
      belt_.tick();  // What waits for its turn to be said need not wait for the belt.
      if (!may_return) continue;
      Result<SerialPort> port = SerialPort::open(options_.port, options_.baud);
      if (port) return std::move(*port);
    }
    return std::nullopt;
  }

  Session& session_;
  const MonitorOptions& options_;
  LiveReport report_;
  LiveBelt belt_;
  Clock::time_point begin_ = Clock::now();
};

int monitor(const MonitorOptions& options) {
  Result<Building> building = load_building(options.session.building);
  if (!building) return bad_input(building.error());
  const Result<std::unique_ptr<Session>> session = options.session.open(std::move(*building), {});
  if (!session) return bad_input(session.error());
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return Monitor(**session, options).run();
}

}  // namespace

void add_monitor(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("monitor", "Room and pose, live from the belt's serial port");
  auto options = std::make_shared<MonitorOptions>();
  options->session.add_to(*command);
  command->add_option("--port", options->port, "Serial device of the belt, or a pseudo-terminal")
      ->required()
      ->check(not_empty());
  command->add_option("--baud", options->baud, "Baud rate")
      ->check(CLI::IsMember({9600, 19200, 38400, 57600, 115200}))
      ->capture_default_str();
  command->callback([options, &status] { status = monitor(*options); });
}

}  // namespace echoway::tools
