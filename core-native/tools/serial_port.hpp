#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "echoway/result.hpp"

namespace echoway::tools {

/// A serial line (or pseudo-terminal), opened raw 8N1 for reading.
class SerialPort {
 public:
  static Result<SerialPort> open(const std::string& path, int baud);
  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;
  ~SerialPort();

  enum class Outcome { data, timeout, closed };
  struct Read {
    Outcome outcome = Outcome::timeout;
    std::size_t count = 0;
  };
  /// Waits at most `timeout_ms` for bytes. `closed`: the other end hung up or the device is gone.
  Read read(std::span<std::uint8_t> buffer, int timeout_ms);

 private:
  explicit SerialPort(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace echoway::tools
