#include "byte_writer.hpp"
#include "layouts.hpp"

namespace echoway::jni {

std::size_t write_belt_health(const BeltHealth& health, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  w.i32(static_cast<std::int32_t>(health.link));
  w.i32(health.sensor_count);
  w.f64(health.firings_per_second);
  w.i64(static_cast<std::int64_t>(health.good_sentences));
  w.i64(static_cast<std::int64_t>(health.bad_checksums));
  w.i64(static_cast<std::int64_t>(health.malformed));
  w.i64(static_cast<std::int64_t>(health.lost_firings));
  w.i64(static_cast<std::int64_t>(health.restarts));
  w.i32(health.has_temperature ? 1 : 0);
  w.i32(health.has_battery ? 1 : 0);
  w.f64(health.temperature_c);
  w.f64(health.battery_v);
  w.raw(health.firmware.data(), health.firmware.size());
  for (const SensorHealth& sensor : health.sensors) {
    w.i32(static_cast<std::int32_t>(sensor.state));
    w.i32(sensor.firings);
    w.i32(sensor.echoes);
    w.i32(sensor.fault_code);
    w.f64(sensor.last_range_m);
    w.f64(sensor.last_time_s);
  }
  return w.size();
}

}  // namespace echoway::jni
