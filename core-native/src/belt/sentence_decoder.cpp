#include <charconv>

#include "belt/firmware_name.hpp"
#include "echoway/belt/sentence.hpp"

namespace echoway {
namespace {

// What a field may say. A second's echo is 170 m away and a kilometre's range is none: both say that the belt is
// broken.
constexpr std::uint32_t kMaxTimeOfFlight = 1'000'000;
constexpr std::uint32_t kMaxRange = 1'000'000;
constexpr int kMinTemperature = -1000;
constexpr int kMaxTemperature = 2000;
constexpr int kMaxBattery = 100'000;

/// A sequence number that goes back by less than this came late on a line that reorders; the belt did not restart.
constexpr std::uint16_t kReorderWindow = 8;

constexpr std::size_t kChecksumLength = 5;  // * and four digits

std::optional<std::uint16_t> parse_checksum(std::string_view digits) noexcept {
  unsigned value = 0;
  for (const char c : digits) {
    const bool decimal = c >= '0' && c <= '9';
    if (!decimal && (c < 'A' || c > 'F')) return std::nullopt;
    value = value << 4U | static_cast<unsigned>(decimal ? c - '0' : c - 'A' + 10);
  }
  return static_cast<std::uint16_t>(value);
}

/// Takes the fields of a sentence in turn; bad() after the first that does not fit.
class Fields {
 public:
  explicit Fields(std::string_view text) noexcept : rest_(text) {}

  std::string_view next() noexcept {
    if (at_end_) {
      bad_ = true;
      return {};
    }
    const std::size_t comma = rest_.find(',');
    const std::string_view field = rest_.substr(0, comma);
    at_end_ = comma == std::string_view::npos;
    if (!at_end_) rest_.remove_prefix(comma + 1);
    return field;
  }

  template <class T>
  T integer(T low, T high) noexcept {
    return to_integer(next(), low, high);
  }

  /// Nothing when the field is empty.
  template <class T>
  std::optional<T> optional_integer(T low, T high) noexcept {
    const std::string_view field = next();
    if (field.empty()) return std::nullopt;
    return to_integer(field, low, high);
  }

  /// Whether every field was there, made sense, and was the last.
  [[nodiscard]] bool good() const noexcept { return at_end_ && !bad_; }

 private:
  template <class T>
  T to_integer(std::string_view field, T low, T high) noexcept {
    long value = 0;
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end || value < static_cast<long>(low) || value > static_cast<long>(high)) {
      bad_ = true;
      return low;
    }
    return static_cast<T>(value);
  }

  std::string_view rest_;
  bool at_end_ = false;
  bool bad_ = false;
};

constexpr std::uint8_t kLastSensor = kMaxSensors - 1;

template <class Firing>
Firing parse_firing(Fields& fields, std::optional<std::uint32_t> Firing::*value, std::uint32_t limit) noexcept {
  Firing out;
  out.seq = fields.integer<std::uint16_t>(0, UINT16_MAX);
  out.sensor = fields.integer<std::uint8_t>(0, kLastSensor);
  out.*value = fields.optional_integer<std::uint32_t>(0, limit);
  return out;
}

StatusSentence parse_status(Fields& fields) noexcept {
  StatusSentence out;
  out.sensors = fields.optional_integer(1, kMaxSensors);
  std::size_t length = 0;
  for (const char c : fields.next()) {
    if (length + 1 < out.firmware.size() && may_stand_in_name(c)) out.firmware[length++] = c;
  }
  out.temperature_dc = fields.optional_integer(kMinTemperature, kMaxTemperature);
  out.battery_mv = fields.optional_integer(0, kMaxBattery);
  return out;
}

FaultSentence parse_fault(Fields& fields) noexcept {
  FaultSentence out;
  out.sensor = fields.integer<std::uint8_t>(0, kLastSensor);
  out.code = fields.integer<std::uint16_t>(0, UINT16_MAX);
  return out;
}

std::optional<Sentence> parse(std::string_view text) noexcept {
  Fields fields(text);
  const std::string_view type = fields.next();
  std::optional<Sentence> sentence;
  if (type == "EWE") {
    sentence = parse_firing<EchoSentence>(fields, &EchoSentence::tof_us, kMaxTimeOfFlight);
  } else if (type == "EWR") {
    sentence = parse_firing<RangeSentence>(fields, &RangeSentence::range_mm, kMaxRange);
  } else if (type == "EWS") {
    sentence = parse_status(fields);
  } else if (type == "EWF") {
    sentence = parse_fault(fields);
  }
  return fields.good() ? sentence : std::nullopt;
}

std::optional<std::uint16_t> seq_of(const Sentence& sentence) noexcept {
  if (const auto* echo = std::get_if<EchoSentence>(&sentence)) return echo->seq;
  if (const auto* range = std::get_if<RangeSentence>(&sentence)) return range->seq;
  return std::nullopt;
}

}  // namespace

std::optional<Sentence> SentenceDecoder::push(std::uint8_t byte) noexcept {
  const char c = static_cast<char>(byte);
  const bool line_end = c == '\r' || c == '\n';
  if (c == '$' || (line_end && in_sentence_)) {
    // A line end that got lost costs nothing: the next `$` ends the sentence as well.
    const std::optional<Sentence> sentence = in_sentence_ ? finish() : std::nullopt;
    in_sentence_ = c == '$';
    length_ = 0;
    return sentence;
  }
  if (!in_sentence_) {
    if (!line_end) ++counts_.skipped_bytes;
    return std::nullopt;
  }
  constexpr std::size_t kFrame = 3;  // $ CR LF
  if (length_ == kMaxSentenceLength - kFrame) {
    ++counts_.overlong;
    in_sentence_ = false;
    return std::nullopt;
  }
  body_[length_++] = c;
  return std::nullopt;
}

std::optional<Sentence> SentenceDecoder::finish() noexcept {
  const std::string_view body(body_.data(), length_);
  if (body.size() < kChecksumLength || body[body.size() - kChecksumLength] != '*') {
    ++counts_.malformed;
    return std::nullopt;
  }
  const std::string_view text = body.substr(0, body.size() - kChecksumLength);
  const std::optional<std::uint16_t> checksum = parse_checksum(body.substr(text.size() + 1));
  if (!checksum || *checksum != crc16(text)) {
    ++counts_.bad_crc;
    return std::nullopt;
  }
  const std::optional<Sentence> sentence = parse(text);
  if (!sentence) {
    ++counts_.malformed;
    return std::nullopt;
  }
  ++counts_.good;
  if (const auto seq = seq_of(*sentence)) count_firing(*seq);
  return sentence;
}

void SentenceDecoder::count_firing(std::uint16_t seq) noexcept {
  if (last_seq_) {
    const auto ahead = static_cast<std::uint16_t>(seq - *last_seq_);
    const auto behind = static_cast<std::uint16_t>(*last_seq_ - seq);
    if (behind < kReorderWindow) return;
    if (ahead > kLargestSeqGap) {
      ++counts_.restarts;
    } else {
      counts_.lost_firings += ahead - 1U;
    }
  }
  last_seq_ = seq;
}

void SentenceDecoder::reset() noexcept {
  in_sentence_ = false;
  length_ = 0;
  last_seq_.reset();
}

}  // namespace echoway
