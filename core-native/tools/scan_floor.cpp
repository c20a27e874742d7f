#include "scan_floor.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "echoway/acoustics/range_model.hpp"

namespace echoway::tools {
namespace {

constexpr double kStep = 1e-3;  // of the numerical derivative, metres
// A position that is worse known than this along its worst direction is not fixed by the scan.
constexpr double kUnobservable = 10.0;

/// Derivative of a sensor's range by the position, as long as the same element answers on both sides.
std::optional<Vec2> gradient(const RangeModel& model, const Pose2& pose, int sensor, const PredictedEcho& here) {
  Vec2 result;
  for (int axis = 0; axis < 2; ++axis) {
    const Vec2 step = axis == 0 ? Vec2{kStep, 0.0} : Vec2{0.0, kStep};
    const PredictedEcho after = model.predict({pose.position + step, pose.heading}, sensor);
    const PredictedEcho before = model.predict({pose.position - step, pose.heading}, sensor);
    if (after.kind != here.kind || before.kind != here.kind || after.index != here.index ||
        before.index != here.index) {
      return std::nullopt;
    }
    (axis == 0 ? result.x : result.y) = (after.range_m - before.range_m) / (2.0 * kStep);
  }
  return result;
}

/// sqrt(trace(J^-1)), J the Fisher information of the ranges: the sum of g g^T / sigma^2.
std::optional<double> scan_floor(const RangeModel& model, const Pose2& pose) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (int sensor = 0; sensor < model.belt().sensors; ++sensor) {
    const PredictedEcho echo = model.predict(pose, sensor);
    if (!echo.has_echo()) continue;
    const std::optional<Vec2> g = gradient(model, pose, sensor, echo);
    if (!g) continue;
    const double weight = 1.0 / std::pow(model.belt().range_noise * echo.range_m, 2);
    xx += weight * g->x * g->x;
    xy += weight * g->x * g->y;
    yy += weight * g->y * g->y;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0.0)) return std::nullopt;
  const double floor = std::sqrt((xx + yy) / determinant);
  return floor < kUnobservable ? std::optional(floor) : std::nullopt;
}

}  // namespace

std::vector<double> scan_floors(const Building& building, const BeltConfig& belt, const std::vector<TruthRow>& stands) {
  const DetectionTable detection(belt);
  std::map<RoomIndex, RangeModel> models;
  std::vector<double> floors;
  for (const TruthRow& stand : stands) {
    const RoomIndex room = building.find_room(stand.room);
    if (room == kNoRoom) continue;
    const auto [model, is_new] =
        models.try_emplace(room, building.room(room), openings_of(building, room), belt, detection);
    if (const std::optional<double> floor = scan_floor(model->second, stand.pose)) floors.push_back(*floor);
  }
  return floors;
}

}  // namespace echoway::tools
