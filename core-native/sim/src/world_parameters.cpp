#include <algorithm>
#include <array>

#include "echoway/sim/world.hpp"

namespace echoway::sim {
namespace {

using W = World;
constexpr double kDegree = kPi / 180.0;

constexpr auto kParameters = std::to_array<WorldParameter>({
    {"transducer_radius_mm", &W::transducer_radius_m, 1e-3, 5, 40, "radius of the vibrating disc"},
    {"frequency_khz", &W::frequency_hz, 1e3, 20, 100, "of the ping"},
    {"plane_margin_db", &W::plane_margin_db, 1, 0, 60,
     "by how much a plane wall 2 m off, on the axis, tops the threshold"},
    {"absorption_db_per_m", &W::absorption_db_per_m, 1, 0, 5, "of air, along the path"},
    {"flutter_db", &W::flutter_db, 1, 0, 10, "standard deviation of an echo's strength"},
    {"range_noise", &W::range_noise, 1, 0, 0.2, "standard deviation, share of the range"},
    {"timer_tick_us", &W::timer_tick_s, 1e-6, 0, 1000, "resolution of the timer that measures the time of flight"},
    {"crosstalk", &W::crosstalk, 1, 0, 1, "share of firings that hear a late echo of the firing before"},
    {"temperature_c", &W::temperature_c, 1, -20, 50, "of the air; the belt assumes 20"},
    {"temperature_gradient_k_per_m", &W::temperature_gradient_k_per_m, 1, 0, 2, "across a level"},
    {"temperature_drift_k_per_min", &W::temperature_drift_k_per_min, 1, -5, 5, "in time"},
    {"thermometer", &W::thermometer, 1, 0, 1, "the log says the temperature at the start"},
    {"reflectivity", &W::reflectivity, 1, 0, 1, "mean amplitude left after a bounce off a wall"},
    {"edge_gain_db", &W::edge_gain_db, 1, -20, 40, "jambs and convex corners above the ideal edge"},
    {"door_casings", &W::door_casings, 1, 0, 1, "share of doors whose frame stands out from the wall"},
    {"rough_walls", &W::rough_walls, 1, 0, 1, "share of walls that answer at any incidence"},
    {"mirror_paths", &W::mirror_paths, 1, 0, 1, "echoes by way of walls that are not met squarely"},
    {"furniture_per_m2", &W::furniture_per_m2, 1, 0, 1, "cupboards, desks, sofas in no plan"},
    {"posts_per_m2", &W::posts_per_m2, 1, 0, 2, "lamp stands, chair and table legs in no plan"},
    {"people_per_100m2", &W::people_per_100m2, 1, 0, 50, "passers-by"},
    {"doors_shut", &W::doors_shut, 1, 0, 1, "share of the doors that the walk does not use"},
    {"door_leaves", &W::door_leaves, 1, 0, 1, "share of open doors whose leaf stands in a room"},
    {"bad_ballasts", &W::bad_ballasts, 1, 0, 1, "share of rooms whose lights disturb the belt"},
    {"arms", &W::arms, 1, 0, 1, "share of the time that the arms swing beside the belt"},
    {"yaw_sway_deg", &W::yaw_sway_rad, kDegree, 0, 30, "amplitude of the chest's turning with each stride"},
    {"side_sway_m", &W::side_sway_m, 1, 0, 0.2, "amplitude of the weaving from side to side"},
    {"speed_variation", &W::speed_variation, 1, 0, 0.5, "slow changes of walking speed, share"},
    {"dropout", &W::dropout, 1, 0, 1, "share of echoes lost for no reason"},
    {"ghost", &W::ghost, 1, 0, 1, "share of firings that report something that is not there"},
    {"steps", &W::steps, 1, 0, 1, "report steps"},
    {"gyro", &W::gyro, 1, 0, 1, "report the yaw rate"},
    {"heading", &W::heading, 1, 0, 1, "report an absolute, drifting heading"},
    {"step_length_m", &W::step_length_m, 1, 0.2, 1.5, "of the wearer"},
    {"step_missed", &W::step_missed, 1, 0, 1, "share of steps that the detector does not see"},
    {"step_invented_per_min", &W::step_invented_per_min, 1, 0, 120, "steps reported that nobody made"},
    {"step_delay_s", &W::step_delay_s, 1, 0, 2, "longest delay of a step event"},
    {"gyro_bias_dps", &W::gyro_bias_rad_s, kDegree, -20, 20, "constant error of the yaw rate"},
    {"gyro_noise_dps", &W::gyro_noise_rad_s, kDegree, 0, 20, "random error of a yaw rate, standard deviation"},
    {"gyro_rate_hz", &W::gyro_rate_hz, 1, 1, 200, "yaw rates a second"},
    {"phone_swing_deg", &W::phone_swing_rad, kDegree, 0, 45,
     "amplitude of the phone's own turning with each stride, as on a thigh"},
    {"heading_offset_deg", &W::heading_offset_rad, kDegree, -180, 180, "error of the absolute heading at the start"},
    {"heading_drift_dps", &W::heading_drift_rad_s, kDegree, -10, 10, "and how it grows"},
});

}  // namespace

double WorldParameter::get(const World& world) const {
  if (const auto* number = std::get_if<double World::*>(&field)) return world.*(*number) / unit;
  return world.*std::get<bool World::*>(field) ? 1.0 : 0.0;
}

void WorldParameter::set(World& world, double value) const {
  if (const auto* number = std::get_if<double World::*>(&field)) {
    world.*(*number) = value * unit;
  } else {
    world.*std::get<bool World::*>(field) = value != 0.0;
  }
}

std::span<const WorldParameter> world_parameters() { return kParameters; }

const WorldParameter* find_world_parameter(std::string_view name) {
  const auto found = std::find_if(kParameters.begin(), kParameters.end(),
                                  [name](const WorldParameter& parameter) { return parameter.name == name; });
  return found == kParameters.end() ? nullptr : &*found;
}

}  // namespace echoway::sim
