#include "scene/between_levels.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {
namespace {

using namespace stairs;

constexpr double kLanding = 1.4;      // Depth of the landings, metres.
constexpr double kLane = 1.3;         // From the middle of one flight to that of the other.
constexpr double kHalfFlight = 0.6;   // Half the breadth of a flight.
constexpr double kTurnIn = 0.7;       // How far out on a landing a wearer turns.
constexpr double kBeltHeight = 1.05;  // Above the feet.
constexpr double kBaluster = 0.012;   // Radius.
constexpr double kFlightRise = kTreads * kRise;
constexpr double kCabinLength = 1.4;
constexpr double kCabinBreadth = 1.1;  // A cabin for eight (EN 81-70).
constexpr double kSteel = 0.95;

/// The one room that there is.
class Enclosure final : public Surroundings {
 public:
  explicit Enclosure(RoomScene scene) : scene_(std::move(scene)) {}
  [[nodiscard]] const std::vector<Doorway>& doorways(RoomIndex) const override { return none_; }
  [[nodiscard]] const RoomScene& scene(RoomIndex) override { return scene_; }
  [[nodiscard]] bool is_open(std::size_t) const override { return false; }
  [[nodiscard]] std::optional<Segment> leaf(RoomIndex, const Doorway&) override { return std::nullopt; }

 private:
  RoomScene scene_;
  std::vector<Doorway> none_;
};

void add_box(Vec2 low, Vec2 high, double reflectivity, RoomScene& scene) {
  const Vec2 corner[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
  for (int i = 0; i < 4; ++i) scene.panels.push_back({{corner[i], corner[(i + 1) % 4]}, reflectivity});
}

// The riser of a flight that stands `above` its foot, if it has one so high, as x from the foot.
void add_riser(double above, double foot, double along, double lane, double reflectivity, RoomScene& scene) {
  if (above <= 0.0 || above >= kFlightRise) return;
  const double x = foot + along * kGoing * std::floor(above / kRise);
  scene.panels.push_back({{{x, lane - kHalfFlight}, {x, lane + kHalfFlight}}, reflectivity});
}

RoomScene stairwell(double feet, int hand, const World& world) {
  RoomScene scene;
  const double lane = hand * kLane;
  add_box({-kLanding, std::min(0.0, lane) - kHalfFlight}, {kRun + kLanding, std::max(0.0, lane) + kHalfFlight},
          world.reflectivity, scene);
  const double belt = feet + kBeltHeight;
  add_riser(belt, 0.0, 1.0, 0.0, world.reflectivity, scene);
  add_riser(belt - kFlightRise, kRun, -1.0, lane, world.reflectivity, scene);
  for (int i = 0; i <= kTreads; ++i) scene.scatterers.push_back({{i * kGoing, 0.5 * lane}, kBaluster, 1.0});
  finish_scene(world, scene);
  return scene;
}

RoomScene cabin(const World& world) {
  RoomScene scene;
  const Vec2 half{0.5 * kCabinLength, 0.5 * kCabinBreadth};
  add_box(-half, half, kSteel, scene);
  finish_scene(world, scene);
  return scene;
}

}  // namespace

namespace stairs {

std::vector<Vec2> path(bool up, int hand) {
  const double lane = hand * kLane;
  std::vector<Vec2> points{{0.0, 0.0},   {kRun, 0.0}, {kRun + kTurnIn, 0.0}, {kRun + kTurnIn, lane},
                           {kRun, lane}, {0.0, lane}};
  if (!up) std::reverse(points.begin(), points.end());
  return points;
}

std::vector<Vec2> landing(bool up, int hand) {
  const double lane = hand * kLane;
  return {{-kTurnIn, up ? lane : 0.0}, {-kTurnIn, up ? 0.0 : lane}};
}

double height(Vec2 at, int hand) noexcept {
  const double along = std::clamp(at.x / kGoing, 0.0, static_cast<double>(kTreads));
  const bool second = at.y * hand > 0.5 * kLane;
  return kRise * (second ? 2.0 * kTreads - along : along);
}

bool on_flight(Vec2 at) noexcept { return at.x > 0.0 && at.x < kRun; }

}  // namespace stairs

const View& BetweenLevelsViews::view_from(const BetweenLevels& place) {
  const bool on_stairs = place.kind == LevelLinkKind::stairs;
  // Feet rest on whole treads.
  const int tread = on_stairs ? static_cast<int>(std::lround(height(place.pose.position, place.hand) / kRise)) : 0;
  const int key = on_stairs ? 1 + 2 * tread + (place.hand > 0 ? 1 : 0) : 0;
  const auto known = views_.find(key);
  if (known != views_.end()) return known->second;
  Enclosure enclosure(on_stairs ? stairwell(tread * kRise, place.hand, world_) : cabin(world_));
  return views_.emplace(key, View(0, enclosure)).first->second;
}

}  // namespace echoway::sim
