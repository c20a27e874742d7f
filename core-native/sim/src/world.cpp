#include "echoway/sim/world.hpp"

namespace echoway::sim {

World make_world(Profile profile) {
  World world;
  switch (profile) {
    case Profile::empty:
      world.furniture_per_m2 = 0.0;
      world.posts_per_m2 = 0.0;
      break;
    case Profile::furnished:
      break;
    case Profile::hard:
      world.furniture_per_m2 = 0.12;
      world.posts_per_m2 = 0.1;
      world.dropout = 0.1;
      world.ghost = 0.04;
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
  world.transducer_radius_m = random.uniform(0.0145, 0.0200);
  world.plane_margin_db = random.uniform(17.0, 27.0);
  world.absorption_db_per_m = random.uniform(1.2, 1.9);
  world.temperature_c = random.uniform(8.0, 32.0);
  world.reflectivity = random.uniform(0.75, 0.95);
  world.edge_gain_db = random.uniform(4.0, 20.0);
  world.furniture_per_m2 = around(world.furniture_per_m2);
  world.posts_per_m2 = around(world.posts_per_m2);
  world.arms = random.uniform(0.0, 1.0);
  world.yaw_sway_rad = around(world.yaw_sway_rad);
  world.side_sway_m = around(world.side_sway_m);
  world.dropout = around(world.dropout);
  world.ghost = around(world.ghost);
  world.step_length_m = random.uniform(0.5, 0.8);
  world.step_missed = random.uniform(0.0, 0.12);
  world.step_invented_per_s = random.uniform(0.0, 0.05);
  world.step_delay_s = random.uniform(0.1, 0.3);
  world.gyro_bias_rad_s = degrees(random.uniform(-1.0, 1.0));
  world.gyro_noise_rad_s = degrees(random.uniform(0.2, 1.0));
  return world;
}

}  // namespace echoway::sim
