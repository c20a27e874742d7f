#include "echoway/sim/world.hpp"

#include "acoustics/receiver.hpp"

namespace echoway::sim {

std::string_view to_string(Profile profile) noexcept {
  switch (profile) {
    case Profile::empty:
      return "empty";
    case Profile::furnished:
      return "furnished";
    case Profile::hard:
      break;
  }
  return "hard";
}

std::optional<Profile> profile_of(std::string_view name) noexcept {
  for (const Profile profile : {Profile::empty, Profile::furnished, Profile::hard}) {
    if (name == to_string(profile)) return profile;
  }
  return std::nullopt;
}

World make_world(Profile profile) {
  World world;
  switch (profile) {
    case Profile::empty:
      world.furniture_per_m2 = 0.0;
      world.posts_per_m2 = 0.0;
      world.people_per_100m2 = 0.0;
      world.rough_walls = 0.0;
      world.door_leaves = 0.0;
      world.doors_shut = 0.0;
      break;
    case Profile::furnished:
      break;
    case Profile::hard:
      world.furniture_per_m2 = 0.2;
      world.posts_per_m2 = 0.2;
      world.people_per_100m2 = 4.0;
      world.rough_walls = 0.3;
      world.doors_shut = 0.4;
      world.bad_ballasts = 0.1;
      world.dropout = 0.1;
      world.arms = 0.8;
      world.ghost = 0.03;
      world.crosstalk = 0.02;
      world.flutter_db = 2.5;
      world.yaw_sway_rad = degrees(6.0);
      world.temperature_c = 32.0;
      world.gyro_bias_rad_s = degrees(1.0);
      break;
  }
  return world;
}

World random_world(Profile profile, Random& random) {
  World world = make_world(profile);
  const auto around = [&random](double value) { return value * random.uniform(0.5, 1.5); };
  // A wall 2 m off answers within 7 to 13 degrees of its normal, as reported for such transducers in different mounts.
  const double half_angle = random.uniform(degrees(7.0), degrees(13.0));
  world.plane_margin_db = random.uniform(14.0, 32.0);
  world.transducer_radius_m = transducer_radius_for(half_angle, world);
  world.absorption_db_per_m = random.uniform(1.2, 1.9);
  world.flutter_db = random.uniform(0.3, 2.0);
  world.crosstalk = around(world.crosstalk);
  world.temperature_c = random.uniform(8.0, 32.0);
  world.temperature_gradient_k_per_m = random.uniform(0.0, 0.1);
  world.temperature_drift_k_per_min = random.uniform(-0.1, 0.1);
  world.reflectivity = random.uniform(0.6, 0.95);
  world.edge_gain_db = random.uniform(0.0, 20.0);
  world.door_casings = random.uniform(0.3, 1.0);
  world.rough_walls *= random.uniform(0.0, 2.0);
  world.furniture_per_m2 *= random.uniform(0.2, 1.8);
  world.posts_per_m2 *= random.uniform(0.2, 1.8);
  world.people_per_100m2 = around(world.people_per_100m2);
  world.doors_shut = around(world.doors_shut);
  world.arms = profile == Profile::hard ? random.uniform(0.5, 1.0) : random.uniform(0.0, 1.0);
  world.yaw_sway_rad = around(world.yaw_sway_rad);
  world.side_sway_m = around(world.side_sway_m);
  // Some real sensors fail to answer a quarter of the time, whatever stands before them.
  world.dropout = random.uniform() < 0.15 ? random.uniform(0.1, 0.3) : around(world.dropout);
  world.ghost = around(world.ghost);
  world.step_length_m = random.uniform(0.5, 0.8);
  world.step_missed = random.uniform(0.0, 0.12);
  world.step_invented_per_min = random.uniform(0.0, 3.0);
  world.step_delay_s = random.uniform(0.1, 0.3);
  world.gyro_bias_rad_s = degrees(random.uniform(-1.0, 1.0));
  world.gyro_noise_rad_s = degrees(random.uniform(0.2, 1.0));
  return world;
}

World ideal_world() {
  World world = make_world(Profile::empty);
  for (const std::string_view none :
       {"flutter_db", "range_noise", "timer_tick_us", "crosstalk", "temperature_gradient_k_per_m",
        "temperature_drift_k_per_min", "arms", "yaw_sway_deg", "side_sway_m", "speed_variation", "dropout", "ghost",
        "step_missed", "step_invented_per_min", "step_delay_s", "gyro_bias_dps", "gyro_noise_dps", "heading_offset_deg",
        "heading_drift_dps"}) {
    find_world_parameter(none)->set(world, 0.0);
  }
  world.temperature_c = kReferenceCelsius;
  world.reflectivity = 1.0;
  world.edge_gain_db = 0.0;
  world.mirror_paths = false;
  world.door_casings = 0.0;
  return world;
}

}  // namespace echoway::sim
