#include "byte_writer.hpp"
#include "layouts.hpp"

namespace echoway::jni {

std::size_t write_estimate(const Estimate& estimate, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  w.f64(estimate.time_s);
  w.f64(estimate.pose.position.x);
  w.f64(estimate.pose.position.y);
  w.f64(estimate.pose.heading);
  w.f64(estimate.sigma_m);
  w.f64(estimate.sigma_heading_rad);
  w.f64(estimate.room_probability);
  w.f64(estimate.covariance_xx);
  w.f64(estimate.covariance_xy);
  w.f64(estimate.covariance_yy);
  w.f64(estimate.speed_mps);
  w.f64(estimate.sound_speed_scale);
  w.i32(estimate.room);
  w.i32(static_cast<std::int32_t>(estimate.state));
  return w.size();
}

}  // namespace echoway::jni
