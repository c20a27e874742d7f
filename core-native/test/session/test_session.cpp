#include "echoway/session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "echoway/belt/sentence.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/random.hpp"

namespace echoway {
namespace {

const std::string kSampleRoom = std::string(ECHOWAY_MAPS_DIR) + "/sample-room";
constexpr double kSlot = 0.0624;

std::span<const std::uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::unique_ptr<Session> open_sample(SessionConfig config = {}) {
  auto session = Session::open(kSampleRoom, config);
  EXPECT_TRUE(session.ok()) << session.error().to_string();
  return std::move(*session);
}

TEST(Session, RefusesConfigurationsThatMakeNoSense) {
  const auto refuses = [](auto change) {
    SessionConfig config;
    change(config);
    return !Session::open(kSampleRoom, config).ok();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.belt.sensors = 0; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.belt.sensors = 65; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.belt.radius_m = -0.1; }));
  EXPECT_TRUE(refuses([&](SessionConfig& c) { c.belt.beam_rad = nan; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.belt.slot_s = 0.0; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.belt.max_range_m = c.belt.min_range_m; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.air_c = -300.0; }));
  EXPECT_TRUE(refuses([&](SessionConfig& c) { c.air_c = nan; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.start.room = 7; }));
  EXPECT_TRUE(refuses([](SessionConfig& c) { c.start.position = Vec2{1, 1}; }));
  EXPECT_TRUE(refuses([&](SessionConfig& c) { c.start = {0, Vec2{nan, 1}, std::nullopt}; }));
  EXPECT_FALSE(refuses([](SessionConfig&) {}));
}

TEST(Session, RefusesAStartFarOutsideItsRoomByEitherMethodAndSaysWhereTheRoomIs) {
  // Who stands in a doorway, or paced out where they stand, may be a little beside the room.
  const Start beside{0, Vec2{-0.9, 1.0}, 0.0};
  const Start far{0, Vec2{-1.1, 1.0}, 0.0};
  for (const Method method : {Method::bayes, Method::thesis}) {
    const auto session = open_sample({.method = method, .start = beside});
    const auto refused = Session::open(kSampleRoom, {.method = method, .start = far});
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find(
                  "the start (-1.1, 1) lies 1.1 m outside room sample, whose floor is between (0, 0) and ("),
              std::string::npos)
        << refused.error().message;
    EXPECT_EQ(session->restart(far).error().message, refused.error().message);
    EXPECT_FALSE(session->restart({0, Vec2{1e300, 1.0}, 0.0}).ok());
  }
}

TEST(Session, ABuildingThatIsMissingIsNamed) {
  const auto session = Session::open("/no/such/building", {});
  ASSERT_FALSE(session.ok());
  EXPECT_NE(session.error().to_string().find("/no/such/building"), std::string::npos);
}

TEST(Session, BytesBecomeFiringsAndHealth) {
  const auto session = open_sample();
  double now = 0.0;
  int firings = 0;
  for (std::uint16_t i = 0; i < 45; ++i, now += kSlot) {
    const EchoSentence echo{i, static_cast<std::uint8_t>(i % 15), i % 3 == 0 ? std::optional(12'000U) : std::nullopt};
    firings += session->on_bytes(as_bytes(encode(echo).text()), now);
  }
  session->on_tick(now);
  EXPECT_EQ(firings, 45);
  EXPECT_EQ(session->belt_health().link, BeltLink::connected);
  EXPECT_EQ(session->belt_health().good_sentences, 45U);
  // 12 ms at 20 degrees: 0.006 s x 343.2 m/s.
  EXPECT_NEAR(session->last_scan()[0].range_m, 0.006 * 343.2, 1e-3);
  EXPECT_FALSE(session->last_scan()[1].has_echo());
  EXPECT_EQ(session->estimate().room, 0);
}

TEST(Session, DamagedBytesAreCountedAndTheBeltsSilenceIsNoticed) {
  const auto session = open_sample();
  std::string bytes;
  for (std::uint16_t i = 0; i < 20; ++i) {
    bytes += encode(EchoSentence{i, static_cast<std::uint8_t>(i % 15), 9'000U}).text();
  }
  bytes[30] ^= 1;
  EXPECT_EQ(session->on_bytes(as_bytes(bytes), 1.0), 19);
  EXPECT_EQ(session->belt_health().bad_checksums + session->belt_health().malformed, 1U);
  EXPECT_EQ(session->belt_health().lost_firings, 1U);
  session->on_tick(3.0);
  EXPECT_EQ(session->belt_health().link, BeltLink::lost);
}

TEST(Session, TheAirsTemperatureIsWorthWhatTheBeltsThermometerSays) {
  const Start start{0, Vec2{2.0, 2.0}, 0.5};
  const auto told = open_sample({.start = start, .air_c = 35.0});
  const auto hears = open_sample({.start = start});
  const auto neither = open_sample({.start = start});
  hears->on_bytes(as_bytes(encode(StatusSentence{.temperature_dc = 350}).text()), 0.0);
  for (int i = 0; i < 90; ++i) {
    for (Session* session : {told.get(), hears.get(), neither.get()}) {
      session->on_firing({kSlot * i, i % 15, 1.5 + 0.1 * (i % 7)});
    }
  }
  EXPECT_EQ(told->estimate().pose.position.x, hears->estimate().pose.position.x);
  EXPECT_NE(told->estimate().pose.position.x, neither->estimate().pose.position.x);
  ASSERT_TRUE(hears->restart(start).ok());
  ASSERT_TRUE(told->restart(start).ok());
  for (int i = 90; i < 180; ++i) {
    for (Session* session : {told.get(), hears.get()}) session->on_firing({kSlot * i, i % 15, 1.5 + 0.1 * (i % 7)});
  }
  EXPECT_EQ(told->estimate().pose.position.x, hears->estimate().pose.position.x);
}

TEST(Session, KeepsItsEstimateWhenTheBeltComesAndGoes) {
  SessionConfig config;
  config.start = {0, Vec2{3.0, 3.0}, 0.0};
  const auto session = open_sample(config);
  session->on_firing({0.0, 0, 2.0});
  const Vec2 before = session->estimate().pose.position;
  session->on_belt_detached(0.5);
  EXPECT_EQ(session->belt_health().link, BeltLink::lost);
  session->on_belt_attached(5.0);
  EXPECT_EQ(session->estimate().pose.position, before);
}

TEST(Session, RestartForgetsWhereTheWearerWas) {
  SessionConfig config;
  config.start = {0, Vec2{1.5, 4.0}, 0.0};
  const auto session = open_sample(config);
  session->on_firing({0.0, 0, Firing::kNoEcho});
  ASSERT_TRUE(session->restart({0, Vec2{4.5, 1.0}, 0.0}).ok());
  session->on_firing({0.1, 1, Firing::kNoEcho});
  EXPECT_NEAR(session->estimate().pose.position.x, 4.5, 0.7);
  EXPECT_FALSE(session->restart({99, std::nullopt, std::nullopt}).ok());
}

TEST(Session, RestartKeepsTheDestinationAndForgetsTheWayThatWasWalked) {
  SessionConfig config;
  config.start = {0, Vec2{1.5, 4.0}, 0.0};
  const auto session = open_sample(config);
  ASSERT_TRUE(session->set_destination({Goal::Kind::spot, -1, {0, {4.5, 1.0}}}).ok());
  EXPECT_FALSE(session->restart({99, std::nullopt, std::nullopt}).ok());
  EXPECT_TRUE(session->has_destination());
  ASSERT_TRUE(session->restart({0, Vec2{4.5, 4.0}, 0.0}).ok());
  EXPECT_TRUE(session->has_destination());
  EXPECT_TRUE(session->breadcrumbs().empty());
  EXPECT_TRUE(session->route().waypoints.empty());
}

TEST(Session, NothingImpossibleBreaksItOrYieldsANan) {
  const double values[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308, -1e308, 0.0, 1.0, 5.0};
  for (const Method method : {Method::bayes, Method::thesis}) {
    SessionConfig config;
    config.method = method;
    const auto session = open_sample(config);
    Random random(4);
    const auto any = [&] { return values[random.next() % std::size(values)]; };
    for (int i = 0; i < 2000; ++i) {
      session->on_firing({any(), static_cast<int>(random.next() % 80) - 8, any()});
      session->on_motion({any(), static_cast<MotionKind>(random.next() % 3), any()});
      session->on_tick(any());
      const Estimate& e = session->estimate();
      ASSERT_TRUE(is_finite(e.pose) && std::isfinite(e.sigma_m) && std::isfinite(e.room_probability)) << "call " << i;
    }
  }
}

}  // namespace
}  // namespace echoway
