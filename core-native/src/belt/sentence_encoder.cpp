#include <charconv>

#include "belt/firmware_name.hpp"
#include "echoway/belt/sentence.hpp"

namespace echoway {
namespace {

/// The fields between `$` and `*`.
class Body {
 public:
  void put(std::string_view s) noexcept {
    for (const char c : s) text_[length_++] = c;
  }
  void integer(long value) noexcept {
    put(",");
    std::array<char, 12> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    put({digits.data(), static_cast<std::size_t>(result.ptr - digits.data())});
  }
  template <class T>
  void integer(const std::optional<T>& value) noexcept {
    if (value) return integer(static_cast<long>(*value));
    put(",");
  }
  void name(std::string_view name) noexcept {
    put(",");
    for (const char c : name) {
      if (may_stand_in_name(c)) put({&c, 1});
    }
  }
  [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), length_}; }

 private:
  std::array<char, kMaxSentenceLength> text_{};
  std::size_t length_ = 0;
};

void write(Body& body, const EchoSentence& echo) noexcept {
  body.put("EWE");
  body.integer(echo.seq);
  body.integer(echo.sensor);
  body.integer(echo.tof_us);
}

void write(Body& body, const RangeSentence& range) noexcept {
  body.put("EWR");
  body.integer(range.seq);
  body.integer(range.sensor);
  body.integer(range.range_mm);
}

void write(Body& body, const StatusSentence& status) noexcept {
  body.put("EWS");
  body.integer(status.sensors);
  body.name(status.firmware_name());
  body.integer(status.temperature_dc);
  body.integer(status.battery_mv);
}

void write(Body& body, const FaultSentence& fault) noexcept {
  body.put("EWF");
  body.integer(fault.sensor);
  body.integer(fault.code);
}

}  // namespace

EncodedSentence encode(const Sentence& sentence) noexcept {
  Body body;
  std::visit([&](const auto& s) { write(body, s); }, sentence);
  EncodedSentence out;
  out.put('$');
  out.put(body.text());
  out.put('*');
  const std::uint16_t checksum = crc16(body.text());
  for (int shift = 12; shift >= 0; shift -= 4) out.put("0123456789ABCDEF"[(checksum >> shift) & 0xF]);
  out.put("\r\n");
  return out;
}

}  // namespace echoway
