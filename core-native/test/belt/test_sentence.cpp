#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "echoway/belt/sentence.hpp"
#include "echoway/random.hpp"

namespace echoway {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::vector<Sentence> feed(SentenceDecoder& decoder, std::string_view text) {
  std::vector<Sentence> out;
  decoder.feed(bytes_of(text), [&](const Sentence& sentence) { out.push_back(sentence); });
  return out;
}

std::vector<Sentence> decode(std::string_view text) {
  SentenceDecoder decoder;
  return feed(decoder, text);
}

/// `count` firings of a belt with 15 sensors, every fifth without echo.
std::string belt_stream(int count, unsigned first_seq = 0) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    EchoSentence echo{.seq = static_cast<std::uint16_t>(first_seq + static_cast<unsigned>(i)),
                      .sensor = static_cast<std::uint8_t>(i % 15),
                      .tof_us = 1000U + static_cast<unsigned>(i)};
    if (i % 5 == 0) echo.tof_us.reset();
    out += encode(echo).text();
  }
  return out;
}

// --- One sentence of each kind; checksums computed with another implementation (Python's binascii.crc_hqx)
// -------------

TEST(Crc16, MatchesThePublishedCheckValue) { EXPECT_EQ(crc16("123456789"), 0x29B1); }

TEST(SentenceDecoder, ReadsAFiring) {
  EXPECT_THAT(decode("$EWE,0,0,7456*D3CD\r\n"), ElementsAre(Sentence(EchoSentence{0, 0, 7456})));
}

TEST(SentenceDecoder, AnEmptyTimeIsNoEcho) {
  EXPECT_THAT(decode("$EWE,65535,14,*2BA0\r\n"), ElementsAre(Sentence(EchoSentence{65535, 14, {}})));
  EXPECT_THAT(decode("$EWR,18,4,*5809\r\n"), ElementsAre(Sentence(RangeSentence{18, 4, {}})));
}

TEST(SentenceDecoder, ReadsARangeComputedByTheBelt) {
  EXPECT_THAT(decode("$EWR,17,3,1280*341D\r\n"), ElementsAre(Sentence(RangeSentence{17, 3, 1280})));
}

TEST(SentenceDecoder, ReadsAStatus) {
  const std::vector<Sentence> sentences = decode("$EWS,15,pic18-1.2,215,7400*F7A2\r\n");
  ASSERT_EQ(sentences.size(), 1U);
  const auto& status = std::get<StatusSentence>(sentences[0]);
  EXPECT_EQ(status.sensors, 15);
  EXPECT_EQ(status.firmware_name(), "pic18-1.2");
  EXPECT_NEAR(*status.temperature_c(), 21.5, 1e-12);
  EXPECT_NEAR(*status.battery_v(), 7.4, 1e-12);
}

TEST(SentenceDecoder, AStatusMayLeaveEverythingEmpty) {
  EXPECT_THAT(decode("$EWS,,,,*3B0E\r\n"), ElementsAre(Sentence(StatusSentence{})));
}

TEST(SentenceDecoder, ReadsAFault) {
  EXPECT_THAT(decode("$EWF,7,2*5C6E\r\n"), ElementsAre(Sentence(FaultSentence{7, 2})));
}

TEST(RangeOf, IsHalfTheWayOfTheSound) {
  EXPECT_NEAR(range_m(EchoSentence{0, 0, 10'000}, 343.2), 1.716, 1e-12);
  EXPECT_NEAR(range_m(RangeSentence{0, 0, 1716}), 1.716, 1e-12);
  EXPECT_EQ(range_m(EchoSentence{}, 343.2), Firing::kNoEcho);
  EXPECT_EQ(range_m(RangeSentence{}), Firing::kNoEcho);
}

// --- Encoder
// -----------------------------------------------------------------------------------------------------------

TEST(Encode, WritesWhatTheWireProtocolShows) {
  EXPECT_EQ(encode(EchoSentence{65535, 14, {}}).text(), "$EWE,65535,14,*2BA0\r\n");
  EXPECT_EQ(encode(RangeSentence{17, 3, 1280}).text(), "$EWR,17,3,1280*341D\r\n");
  EXPECT_EQ(encode(StatusSentence{}).text(), "$EWS,,,,*3B0E\r\n");
  EXPECT_EQ(encode(FaultSentence{7, 2}).text(), "$EWF,7,2*5C6E\r\n");
}

TEST(Encode, TheLongestSentencesFitAndComeBack) {
  StatusSentence status{.sensors = kMaxSensors, .temperature_dc = -1000, .battery_mv = 100'000};
  std::fill_n(status.firmware.begin(), status.firmware.size() - 1, 'x');
  for (const Sentence& sentence : {Sentence(status), Sentence(EchoSentence{65535, 63, 1'000'000})}) {
    const EncodedSentence encoded = encode(sentence);
    EXPECT_LE(encoded.text().size(), kMaxSentenceLength);
    EXPECT_THAT(decode(encoded.text()), ElementsAre(sentence));
  }
}

TEST(Encode, AFirmwaresNameCannotBreakTheSentence) {
  StatusSentence status;
  std::string_view("a,b*c$d\re").copy(status.firmware.data(), 23);
  const std::vector<Sentence> sentences = decode(encode(status).text());
  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_EQ(std::get<StatusSentence>(sentences[0]).firmware_name(), "abcde");
}

// --- What must not pass
// ------------------------------------------------------------------------------------------------

TEST(SentenceDecoder, NeverUsesABadChecksum) {
  SentenceDecoder decoder;
  EXPECT_THAT(feed(decoder, "$EWE,0,0,7457*D3CD\r\n$EWE,0,0,7456*D3CE\r\n$EWE,0,0,7456*d3cd\r\n"), IsEmpty());
  EXPECT_EQ(decoder.counts().bad_crc, 3U);
  EXPECT_EQ(decoder.counts().good, 0U);
}

TEST(SentenceDecoder, DropsGoodChecksumsWithSenselessFields) {
  SentenceDecoder decoder;
  EXPECT_THAT(feed(decoder,
                   "$EWX,1,2*253C\r\n$EWE,1,64,100*6EF3\r\n$EWE,1,2*001C\r\n$EWE,65536,2,100*F536\r\n"
                   "$EWE,1,2,100,5*DB14\r\n$EWE,1,-2,100*7A50\r\n$EWE,1,2,1e3*4E04\r\n$EWE,1, 2,100*3413\r\n"),
              IsEmpty());
  EXPECT_EQ(decoder.counts().malformed, 8U);
  EXPECT_EQ(decoder.counts().bad_crc, 0U);
}

TEST(SentenceDecoder, DropsASentenceOfMoreThan82Characters) {
  const auto padded = [](std::size_t total) {
    const std::string body = "EWF," + std::string(total - 14, '0') + ",1";
    char tail[8];
    std::snprintf(tail, sizeof tail, "*%04X", crc16(body));
    return "$" + body + tail + "\r\n";
  };
  SentenceDecoder decoder;
  ASSERT_EQ(padded(82).size(), 82U);
  EXPECT_EQ(feed(decoder, padded(82)).size(), 1U);
  EXPECT_THAT(feed(decoder, padded(83)), IsEmpty());
  EXPECT_EQ(decoder.counts().overlong, 1U);
  EXPECT_EQ(feed(decoder, "$EWF,7,2*5C6E\r\n").size(), 1U) << "the next sentence is found again";
}

// --- Cut, merged, flipped and flooded bytes
// ----------------------------------------------------------------------------

TEST(SentenceDecoder, GivesTheSameWhereverTheBytesAreCut) {
  const std::string stream = belt_stream(20);
  const std::vector<Sentence> whole = decode(stream);
  ASSERT_EQ(whole.size(), 20U);
  for (std::size_t chunk = 1; chunk <= 40; ++chunk) {
    SentenceDecoder decoder;
    std::vector<Sentence> pieces;
    for (std::size_t i = 0; i < stream.size(); i += chunk) {
      for (const Sentence& s : feed(decoder, std::string_view(stream).substr(i, chunk))) pieces.push_back(s);
    }
    EXPECT_EQ(pieces, whole) << chunk;
  }
}

TEST(SentenceDecoder, JoiningAStreamAnywhereLosesOnlyTheSentenceUnderWay) {
  const std::string stream = belt_stream(5);
  const std::size_t first = encode(EchoSentence{0, 0, {}}).text().size();
  for (std::size_t cut = 1; cut <= first; ++cut) {
    EXPECT_EQ(decode(std::string_view(stream).substr(cut)).size(), 4U) << cut;
  }
}

TEST(SentenceDecoder, AStreamThatBreaksOffAnywhereSpoilsNothingAfterIt) {
  const std::string stream = belt_stream(5);
  const std::vector<Sentence> whole = decode(stream);
  for (std::size_t cut = 0; cut < stream.size(); ++cut) {
    SentenceDecoder decoder;
    feed(decoder, std::string_view(stream).substr(0, cut));
    const std::vector<Sentence> after = feed(decoder, stream);
    ASSERT_GE(after.size(), 5U) << cut;
    EXPECT_TRUE(std::equal(whole.begin(), whole.end(), after.end() - 5)) << cut;
  }
}

TEST(SentenceDecoder, ALostLineEndMergesNoSentences) {
  SentenceDecoder decoder;
  EXPECT_EQ(feed(decoder, "$EWF,7,2*5C6E$EWF,7,2*5C6E\r$EWF,7,2*5C6E\n$EWF,7,2*5C6E\r\n").size(), 4U);
  EXPECT_EQ(decoder.counts().malformed, 0U);
}

TEST(SentenceDecoder, ASentenceThatStartsInsideAnotherIsNotLost) {
  SentenceDecoder decoder;
  EXPECT_EQ(feed(decoder, "$EWE,0,0,74$EWF,7,2*5C6E\r\n").size(), 1U);
  EXPECT_EQ(decoder.counts().malformed, 1U);
}

TEST(SentenceDecoder, EverySingleFlippedBitIsCaught) {
  const std::string stream = belt_stream(3);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string flipped = stream;
      flipped[i] = static_cast<char>(static_cast<unsigned char>(flipped[i]) ^ (1U << bit));
      const std::vector<Sentence> whole = decode(stream);
      const std::vector<Sentence> found = decode(flipped);
      EXPECT_GE(found.size(), 2U) << "at most the sentence that was hit is lost";
      for (const Sentence& sentence : found) {
        EXPECT_NE(std::find(whole.begin(), whole.end(), sentence), whole.end()) << "byte " << i << " bit " << bit;
      }
    }
  }
}

TEST(SentenceDecoder, EveryLostOrDoubledByteIsCaught) {
  const std::string stream = belt_stream(3);
  const std::vector<Sentence> whole = decode(stream);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    std::string lost = stream;
    lost.erase(i, 1);
    std::string doubled = stream;
    doubled.insert(i, 1, stream[i]);
    for (const std::string& broken : {lost, doubled}) {
      const std::vector<Sentence> found = decode(broken);
      EXPECT_GE(found.size(), 2U);
      for (const Sentence& sentence : found) {
        EXPECT_NE(std::find(whole.begin(), whole.end(), sentence), whole.end()) << "byte " << i;
      }
    }
  }
}

TEST(SentenceDecoder, FindsEverySentenceInAFloodOfNoise) {
  Random random(7);
  SentenceDecoder decoder;
  constexpr int kSentences = 500;
  int found = 0;
  for (int i = 0; i < kSentences; ++i) {
    std::string noise;
    const auto length = random.next() % 400;
    for (std::uint64_t k = 0; k < length; ++k) noise += static_cast<char>(random.next());
    feed(decoder, noise);
    const FaultSentence expected{static_cast<std::uint8_t>(i % kMaxSensors), static_cast<std::uint16_t>(i)};
    for (const Sentence& sentence : feed(decoder, encode(expected).text())) found += sentence == Sentence(expected);
  }
  EXPECT_EQ(found, kSentences);
  EXPECT_EQ(decoder.counts().good, static_cast<std::uint64_t>(kSentences));
}

TEST(SentenceDecoder, AFloodWithoutASentenceIsCountedAndForgotten) {
  SentenceDecoder decoder;
  feed(decoder, std::string(100'000, 'x'));
  EXPECT_EQ(decoder.counts().skipped_bytes, 100'000U);
  feed(decoder, std::string(1000, '$'));
  EXPECT_EQ(decoder.counts().malformed, 999U);
  EXPECT_EQ(feed(decoder, belt_stream(1)).size(), 1U);
}

// --- Sequence numbers
// --------------------------------------------------------------------------------------------------

TEST(SentenceDecoder, CountsFiringsLostOnTheWay) {
  SentenceDecoder decoder;
  feed(decoder, belt_stream(3, 65534));
  EXPECT_EQ(decoder.counts().lost_firings, 0U) << "65535 is followed by 0";
  feed(decoder, belt_stream(1, 11));
  EXPECT_EQ(decoder.counts().lost_firings, 10U);
  EXPECT_EQ(decoder.counts().restarts, 0U);
}

TEST(SentenceDecoder, NoticesThatTheBeltStartedOver) {
  SentenceDecoder decoder;
  feed(decoder, belt_stream(300));
  feed(decoder, belt_stream(5));
  EXPECT_EQ(decoder.counts().restarts, 1U);
  EXPECT_EQ(decoder.counts().lost_firings, 0U);
}

TEST(SentenceDecoder, RepeatedAndReorderedSentencesAreNoRestart) {
  SentenceDecoder decoder;
  for (const unsigned seq : {100U, 101U, 103U, 102U, 103U, 104U}) feed(decoder, belt_stream(1, seq));
  EXPECT_EQ(decoder.counts().restarts, 0U);
  EXPECT_EQ(decoder.counts().good, 6U);
}

TEST(SentenceDecoder, APortOpenedAnewStartsANewCount) {
  SentenceDecoder decoder;
  feed(decoder, belt_stream(2, 1000));
  feed(decoder, "$EWE,1002,");
  decoder.reset();
  EXPECT_EQ(feed(decoder, belt_stream(2, 5)).size(), 2U);
  EXPECT_EQ(decoder.counts().lost_firings + decoder.counts().restarts + decoder.counts().malformed, 0U);
}

}  // namespace
}  // namespace echoway
