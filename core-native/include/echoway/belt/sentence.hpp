#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "echoway/belt/belt.hpp"

namespace echoway {

// The belt's wire protocol (docs/wire-protocol.md): sentences in the shape of NMEA 0183,
// `$<type>,<field>,...*<CRC-16/CCITT-FALSE as four upper-case hex digits>` CR LF.

/// Characters of a sentence from `$` to LF, both included.
inline constexpr std::size_t kMaxSentenceLength = 82;

/// `$EWE,<seq>,<sensor>,<tof_us>`: one firing, with the time until the echo came back.
struct EchoSentence {
  std::uint16_t seq = 0;                ///< Counts firings modulo 65536.
  std::uint8_t sensor = 0;              ///< 0 ... kMaxSensors - 1.
  std::optional<std::uint32_t> tof_us;  ///< There and back, microseconds; nothing = no echo.
  friend bool operator==(const EchoSentence&, const EchoSentence&) = default;
};

/// `$EWR,<seq>,<sensor>,<range_mm>`: one firing of a belt that computes the distance itself, as the thesis's does.
struct RangeSentence {
  std::uint16_t seq = 0;
  std::uint8_t sensor = 0;
  std::optional<std::uint32_t> range_mm;  ///< Nothing = no echo.
  friend bool operator==(const RangeSentence&, const RangeSentence&) = default;
};

/// `$EWS,<sensors>,<firmware>,<temp_dC>,<battery_mV>`: about once a second; a belt leaves empty what it does not know.
struct StatusSentence {
  std::optional<int> sensors;         ///< 1 ... kMaxSensors.
  std::array<char, 24> firmware{};    ///< NUL-terminated, cut to fit.
  std::optional<int> temperature_dc;  ///< Tenths of a degree Celsius, -1000 ... 2000.
  std::optional<int> battery_mv;      ///< 0 ... 100,000.

  [[nodiscard]] std::string_view firmware_name() const noexcept { return firmware.data(); }
  [[nodiscard]] std::optional<double> temperature_c() const noexcept {
    return temperature_dc ? std::optional(0.1 * *temperature_dc) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> battery_v() const noexcept {
    return battery_mv ? std::optional(1e-3 * *battery_mv) : std::nullopt;
  }
  friend bool operator==(const StatusSentence&, const StatusSentence&) = default;
};

/// `$EWF,<sensor>,<code>`: a sensor fault.
struct FaultSentence {
  std::uint8_t sensor = 0;
  std::uint16_t code = 0;
  friend bool operator==(const FaultSentence&, const FaultSentence&) = default;
};

using Sentence = std::variant<EchoSentence, RangeSentence, StatusSentence, FaultSentence>;

/// Range to whatever answered, metres: half the way that sound goes in the time of flight (thesis section 4.1).
/// Firing::kNoEcho when there was no echo. `speed_of_sound`: metres a second, see speed_of_sound().
[[nodiscard]] constexpr double range_m(const EchoSentence& echo, double speed_of_sound) noexcept {
  return echo.tof_us ? 0.5e-6 * *echo.tof_us * speed_of_sound : Firing::kNoEcho;
}
[[nodiscard]] constexpr double range_m(const RangeSentence& range) noexcept {
  return range.range_mm ? 1e-3 * *range.range_mm : Firing::kNoEcho;
}

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, nothing reflected; 0x29B1 for "123456789".
[[nodiscard]] std::uint16_t crc16(std::string_view bytes) noexcept;

/// What a decoder has seen. Everything that it does not hand on is counted in exactly one of the dropped kinds.
struct SentenceCounts {
  std::uint64_t good = 0;
  std::uint64_t bad_crc = 0;        ///< Dropped: the checksum does not fit.
  std::uint64_t malformed = 0;      ///< Dropped: cut short, no checksum, an unknown type, or fields that make no sense.
  std::uint64_t overlong = 0;       ///< Dropped: longer than kMaxSentenceLength.
  std::uint64_t skipped_bytes = 0;  ///< Dropped: bytes between sentences that end no line.
  std::uint64_t lost_firings = 0;   ///< Gaps in the sequence numbers.
  std::uint64_t restarts = 0;       ///< Times the sequence numbers started over: the belt rebooted.
  friend bool operator==(const SentenceCounts&, const SentenceCounts&) = default;
};

/// Sequence numbers that jump ahead by more than this are taken for a belt that started over, not for firings lost:
/// four minutes at 16 a second.
inline constexpr std::uint16_t kLargestSeqGap = 4096;

/// Turns a serial line's bytes, cut anywhere, into sentences.
///
/// Guarantees: 1. whatever the bytes, it finds the next sentence at the next `$`; 2. a sentence whose checksum does not
/// fit is never handed on; 3. constant time a byte, constant memory, nothing allocated, nothing thrown.
class SentenceDecoder {
 public:
  /// Calls `sink(const Sentence&)` for every sentence that `bytes` completes, in order.
  template <class Sink>
  void feed(std::span<const std::uint8_t> bytes, Sink&& sink) {
    for (const std::uint8_t byte : bytes) {
      if (const std::optional<Sentence> sentence = push(byte)) sink(*sentence);
    }
  }

  /// The sentence that `byte` completes, if it does.
  std::optional<Sentence> push(std::uint8_t byte) noexcept;

  /// Forgets a sentence under way and the sequence numbers (the port was opened anew); keeps the counts.
  void reset() noexcept;

  [[nodiscard]] const SentenceCounts& counts() const noexcept { return counts_; }

 private:
  std::optional<Sentence> finish() noexcept;
  void count_firing(std::uint16_t seq) noexcept;

  std::array<char, kMaxSentenceLength> body_{};  ///< What follows the `$`.
  std::size_t length_ = 0;
  bool in_sentence_ = false;
  std::optional<std::uint16_t> last_seq_;
  SentenceCounts counts_;
};

/// A sentence ready to send, from `$` to LF.
class EncodedSentence {
 public:
  [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), length_}; }

 private:
  friend EncodedSentence encode(const Sentence& sentence) noexcept;
  void put(char c) noexcept { text_[length_++] = c; }
  void put(std::string_view s) noexcept {
    for (const char c : s) put(c);
  }

  std::array<char, kMaxSentenceLength> text_{};
  std::size_t length_ = 0;
};

/// What a belt sends for `sentence`. Characters of a firmware's name that would break a sentence are left out.
/// REQUIRES: fields within the ranges documented above.
[[nodiscard]] EncodedSentence encode(const Sentence& sentence) noexcept;

}  // namespace echoway
