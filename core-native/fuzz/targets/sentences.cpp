#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "echoway/belt/sentence.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

std::string check(const EchoSentence& s) { return s.sensor < kMaxSensors ? "" : "sensor out of range"; }
std::string check(const RangeSentence& s) { return s.sensor < kMaxSensors ? "" : "sensor out of range"; }
std::string check(const FaultSentence& s) { return s.sensor < kMaxSensors ? "" : "sensor out of range"; }
std::string check(const StatusSentence& s) {
  if (s.sensors && (*s.sensors < 1 || *s.sensors > kMaxSensors)) return "sensor count out of range";
  if (s.firmware.back() != '\0') return "firmware without an end";
  if (s.temperature_dc && (*s.temperature_dc < -1000 || *s.temperature_dc > 2000)) return "temperature out of range";
  if (s.battery_mv && (*s.battery_mv < 0 || *s.battery_mv > 100000)) return "voltage out of range";
  return "";
}

std::vector<Sentence> decode(Bytes data, std::size_t piece, SentenceCounts& counts) {
  SentenceDecoder decoder;
  std::vector<Sentence> out;
  for (std::size_t at = 0; at < data.size(); at += piece) {
    decoder.feed(data.subspan(at, std::min(piece, data.size() - at)), [&](const Sentence& s) { out.push_back(s); });
  }
  counts = decoder.counts();
  return out;
}

/// The same lines, each with a checksum that fits: without that hardly an input ever gets as far as its fields.
std::string with_checksums(Bytes data) {
  std::string out;
  std::string_view rest(reinterpret_cast<const char*>(data.data()), data.size());
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const std::string_view body = line.substr(std::min(line.find_first_not_of('$'), line.size()));
    const std::string_view fields = body.substr(0, body.find('*'));
    char checksum[8];
    std::snprintf(checksum, sizeof checksum, "*%04X\r\n", static_cast<unsigned>(crc16(fields)));
    out.append("$").append(fields).append(checksum);
  }
  return out;
}

std::string check_stream(Bytes data) {
  SentenceCounts counts;
  const std::vector<Sentence> whole = decode(data, std::max<std::size_t>(1, data.size()), counts);
  if (counts.good != whole.size()) return "sentences handed on and counted differ";
  SentenceCounts cut_counts;
  if (decode(data, 7, cut_counts) != whole || cut_counts != counts) return "the cuts between reads make a difference";
  for (const Sentence& sentence : whole) {
    if (std::string broken = std::visit([](const auto& s) { return check(s); }, sentence); !broken.empty()) {
      return broken;
    }
    const EncodedSentence sent = encode(sentence);
    if (sent.text().size() > kMaxSentenceLength) return "a sentence too long to send";
    const std::string_view text = sent.text();
    SentenceCounts again_counts;
    const auto again =
        decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, text.size(), again_counts);
    if (again.size() != 1 || again[0] != sentence) return "a sentence that does not read back";
  }
  return "";
}

}  // namespace

std::string sentences(Bytes data) {
  if (std::string broken = check_stream(data); !broken.empty()) return broken;
  const std::string whole = with_checksums(data);
  return check_stream({reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()});
}

}  // namespace echoway::fuzz
