#include "serial_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace echoway::tools {
namespace {

bool to_speed(int baud, speed_t& speed) {
  switch (baud) {
    case 9600: speed = B9600; return true;
    case 19200: speed = B19200; return true;
    case 38400: speed = B38400; return true;
    case 57600: speed = B57600; return true;
    case 115200: speed = B115200; return true;
    default: return false;
  }
}

bool configure(int descriptor, speed_t speed) {
  termios settings{};
  if (tcgetattr(descriptor, &settings) != 0) return false;
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | PARENB | CRTSCTS);
  cfsetspeed(&settings, speed);
  return tcsetattr(descriptor, TCSANOW, &settings) == 0;
}

}  // namespace

Result<SerialPort> SerialPort::open(const std::string& path, int baud) {
  speed_t speed{};
  if (!to_speed(baud, speed)) {
    return Error{"baud rate " + std::to_string(baud) + " is not supported; use 9600, 19200, 38400, 57600 or 115200"};
  }
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return Error{std::string("cannot open the port: ") + std::strerror(errno), path};
  SerialPort port(descriptor);
  if (!configure(descriptor, speed)) return Error{"not a serial port; give the belt's device, e.g. /dev/ttyUSB0", path};
  return port;
}

SerialPort::SerialPort(SerialPort&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

SerialPort& SerialPort::operator=(SerialPort&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

SerialPort::~SerialPort() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

SerialPort::Read SerialPort::read(std::span<std::uint8_t> buffer, int timeout_ms) {
  pollfd waiting{descriptor_, POLLIN, 0};
  const int ready = ::poll(&waiting, 1, timeout_ms);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return {Outcome::timeout, 0};
  const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
  if (count > 0) return {Outcome::data, static_cast<std::size_t>(count)};
  if (count < 0 && (errno == EAGAIN || errno == EINTR) && (waiting.revents & (POLLHUP | POLLERR)) == 0) {
    return {Outcome::timeout, 0};
  }
  return {Outcome::closed, 0};
}

}  // namespace echoway::tools
