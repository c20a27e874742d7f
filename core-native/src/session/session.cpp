#include "echoway/session.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "echoway/belt/belt_monitor.hpp"
#include "echoway/belt/firing_clock.hpp"
#include "echoway/belt/sentence.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/guidance/advise.hpp"
#include "echoway/guidance/guide.hpp"
#include "echoway/locate/start_check.hpp"
#include "session/make_locator.hpp"

namespace echoway {
namespace {

Status check_belt(const BeltConfig& belt) {
  if (belt.sensors < 1 || belt.sensors > kMaxSensors) {
    return Error{"the belt has " + std::to_string(belt.sensors) + " sensors; 1 to " + std::to_string(kMaxSensors) +
                 " are possible"};
  }
  const std::array<double, 7> positive{belt.beam_rad,    belt.slot_s,      belt.min_range_m,
                                       belt.max_range_m, belt.range_noise, belt.max_range_m - belt.min_range_m,
                                       belt.temperature_c + 273.15};
  for (const double value : positive) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      return Error{"the belt's beam, slot, ranges, noise or temperature is not a positive, finite number"};
    }
  }
  if (!(belt.radius_m >= 0.0) || !std::isfinite(belt.radius_m)) {
    return Error{"the belt's radius is negative or not finite"};
  }
  return success();
}

Status check_config(const SessionConfig& config, const Building& building) {
  if (building.rooms.empty()) return Error{"the building has no rooms"};
  if (config.air_c && !(*config.air_c > -273.15 && std::isfinite(*config.air_c))) {
    return Error{"the air's temperature is none"};
  }
  if (Status belt = check_belt(config.belt); !belt) return belt;
  return check_start(config.start, building);
}

GuideConfig guide_config(const BeltConfig& belt) {
  GuideConfig config;
  config.belt = belt;
  return config;
}

Result<std::unique_ptr<Locator>> begin_to_locate(const Building& building, const SessionConfig& config) {
  Result<std::unique_ptr<Locator>> locator = make_locator(building, config);
  if (locator && config.air_c) (*locator)->on_temperature(*config.air_c);
  return locator;
}

}  // namespace

struct Session::Impl {
  Impl(Building model, const SessionConfig& configuration)
      : building(std::move(model)),
        config(configuration),
        sound_speed(speed_of_sound(config.belt.temperature_c)),
        clock(config.belt.slot_s),
        monitor(config.belt.sensors),
        router(building),
        guide(router, guide_config(config.belt)) {
    for (int i = 0; i < config.belt.sensors; ++i) last_scan[static_cast<std::size_t>(i)] = {-1.0, i, Firing::kNoEcho};
  }

  bool take_firing(const Firing& firing) {
    if (!std::isfinite(firing.time_s) || !std::isfinite(firing.range_m)) return false;
    monitor.on_firing(firing);
    if (firing.sensor >= 0 && firing.sensor < config.belt.sensors) {
      last_scan[static_cast<std::size_t>(firing.sensor)] = firing;
    }
    const bool renewed = locator->on_firing(firing);
    if (firing.sensor >= 0 && firing.sensor < config.belt.sensors) {
      fired_from[static_cast<std::size_t>(firing.sensor)] = locator->estimate();
    }
    if (renewed) {
      monitor.set_suspicions(locator->suspicions());
      guide.on_estimate(locator->estimate(), locator->hypotheses());
      advise(*locator, guide);
    }
    guide.on_firing(firing);
    guide.on_belt_health(monitor.health(), firing.time_s);
    return renewed;
  }

  void tick(double now_s) {
    monitor.on_tick(now_s);
    guide.on_belt_health(monitor.health(), now_s);
  }

  void take(const EchoSentence& echo) { take_numbered(echo.seq, echo.sensor, range_m(echo, sound_speed)); }
  void take(const RangeSentence& range) { take_numbered(range.seq, range.sensor, range_m(range)); }
  void take(const FaultSentence& fault) { monitor.on_fault(fault.sensor, fault.code, arrival); }
  void take(const StatusSentence& status) {
    monitor.on_status(status.sensors, status.firmware_name(), status.temperature_c(), status.battery_v(), arrival);
    if (!status.temperature_c()) return;
    config.air_c = status.temperature_c();
    locator->on_temperature(*config.air_c);
  }

  void take_numbered(std::uint16_t seq, int sensor, double range) {
    ++firings_taken;
    take_firing({clock.stamp(seq, arrival).time_s, sensor, range});
  }

  /// The one they are found in or, before, said that they are in.
  [[nodiscard]] RoomIndex wearers_room() const {
    const RoomIndex found = locator->estimate().room;
    return building.has_room(found) ? found : config.start.room.value_or(kNoRoom);
  }

  void copy_counters() {
    const SentenceCounts& counts = decoder.counts();
    BeltHealth& health = monitor.counters();
    health.good_sentences = counts.good;
    health.bad_checksums = counts.bad_crc;
    health.malformed = counts.malformed + counts.overlong;
    health.lost_firings = counts.lost_firings;
    health.restarts = counts.restarts;
  }

  Building building;
  SessionConfig config;
  double sound_speed;                // at which times of flight become ranges
  std::unique_ptr<Locator> locator;  // refers to `building`
  SentenceDecoder decoder;
  FiringClock clock;
  BeltMonitor monitor;
  Router router;                     // refers to `building`
  Guide guide;
  std::array<Firing, kMaxSensors> last_scan{};
  std::array<Estimate, kMaxSensors> fired_from{};        // where the wearer was at each of those
  std::unique_ptr<EchoExplainer> explainer;              // refers to `building`; made when first asked
  std::array<ExplainedEcho, kMaxSensors> explained{};
  double arrival = 0.0;              // of the bytes being taken
  int firings_taken = 0;
};

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::~Session() = default;

Result<std::unique_ptr<Session>> Session::open(const std::filesystem::path& building_dir, const SessionConfig& config) {
  Result<Building> building = load_building(building_dir);
  if (!building) return building.error();
  return open(std::move(*building), config);
}

Result<std::unique_ptr<Session>> Session::open(Building building, const SessionConfig& config) {
  if (const Status good = check_config(config, building); !good) return good.error();
  auto impl = std::make_unique<Impl>(std::move(building), config);
  Result<std::unique_ptr<Locator>> locator = begin_to_locate(impl->building, config);
  if (!locator) return locator.error();
  impl->locator = std::move(*locator);
  impl->guide.on_start(config.start);
  return std::unique_ptr<Session>(new Session(std::move(impl)));
}

int Session::on_bytes(std::span<const std::uint8_t> bytes, double arrival_s) {
  if (!std::isfinite(arrival_s)) return 0;
  impl_->arrival = arrival_s;
  impl_->firings_taken = 0;
  impl_->decoder.feed(bytes, [this](const Sentence& sentence) {
    impl_->monitor.heard(impl_->arrival);
    std::visit([this](const auto& kind) { impl_->take(kind); }, sentence);
  });
  impl_->copy_counters();
  return impl_->firings_taken;
}

bool Session::on_firing(const Firing& firing) { return impl_->take_firing(firing); }

void Session::on_motion(const MotionHint& hint) {
  if (std::isfinite(hint.time_s) && std::isfinite(hint.value)) impl_->locator->on_motion(hint);
}

void Session::on_tick(double now_s) { impl_->tick(now_s); }

void Session::on_belt_attached(double now_s) {
  impl_->decoder.reset();
  impl_->clock.reset();
  impl_->tick(now_s);
}

void Session::on_belt_detached(double now_s) {
  impl_->monitor.on_detached();
  impl_->tick(now_s);
}

Status Session::restart(const Start& start) {
  if (Status good = check_start(start, impl_->building); !good) return good;
  SessionConfig config = impl_->config;
  config.start = start;
  Result<std::unique_ptr<Locator>> locator = begin_to_locate(impl_->building, config);
  if (!locator) return locator.error();
  impl_->config = config;
  impl_->locator = std::move(*locator);
  impl_->fired_from = {};
  impl_->guide.on_start(start);
  return success();
}

Status Session::set_destination(std::string_view name, RoutePreferences preferences) {
  return impl_->guide.set_destination(name, preferences, impl_->wearers_room());
}

Status Session::set_destination(const Goal& goal, RoutePreferences preferences) {
  return impl_->guide.set_destination(goal, preferences, impl_->wearers_room());
}

Status Session::way_out(RoutePreferences preferences) {
  return impl_->guide.way_out(preferences, impl_->wearers_room());
}
Status Session::back_track() { return impl_->guide.back_track(); }
void Session::clear_destination() { impl_->guide.clear_destination(); }
void Session::where_am_i() { impl_->guide.where_am_i(); }
bool Session::repeat() { return impl_->guide.repeat(); }
bool Session::next_cue(Cue& cue) { return impl_->guide.next_cue(cue); }
double Session::repeat_gap_s() const { return impl_->guide.config().repeat_gap_s; }
bool Session::has_destination() const { return impl_->guide.has_destination(); }
Status Session::check_way_from_start() const {
  const Start& start = impl_->config.start;
  return start.room ? impl_->guide.check_way(*start.room, start.position) : success();
}
double Session::obstacle_ahead_m() const { return impl_->guide.obstacle_ahead_m(); }
const Route& Session::route() const { return impl_->guide.route(); }
std::span<const Spot> Session::breadcrumbs() const { return impl_->guide.breadcrumbs(); }

const Building& Session::building() const { return impl_->building; }
const SessionConfig& Session::config() const { return impl_->config; }
const Estimate& Session::estimate() const { return impl_->locator->estimate(); }
std::span<const Hypothesis> Session::hypotheses() const { return impl_->locator->hypotheses(); }
const BeltHealth& Session::belt_health() const { return impl_->monitor.health(); }

std::span<const Firing> Session::last_scan() const {
  return std::span(impl_->last_scan).first(static_cast<std::size_t>(impl_->config.belt.sensors));
}

std::span<const ExplainedEcho> Session::explain_scan() {
  Impl& s = *impl_;
  if (!s.explainer) s.explainer = std::make_unique<EchoExplainer>(s.building, s.config.belt);
  const auto sensors = static_cast<std::size_t>(s.config.belt.sensors);
  for (std::size_t i = 0; i < sensors; ++i) s.explained[i] = s.explainer->explain(s.last_scan[i], s.fired_from[i]);
  return std::span(s.explained).first(sensors);
}

SceneReport Session::report_scene() const { return echoway::report_scene(impl_->building, impl_->config.belt); }

}  // namespace echoway
