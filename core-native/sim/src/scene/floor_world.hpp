#pragma once

#include <map>
#include <set>
#include <vector>

#include "plan/floor_plan.hpp"
#include "scene/view.hpp"

namespace echoway::sim {

/// Places and doors that the wearer uses: nothing is put there, and they are not shut by chance.
struct Footprint {
  std::map<RoomIndex, std::vector<Vec2>> places;  ///< In each room's frame, about 0.1 m apart.
  std::set<std::size_t> doors;                    ///< Indices into Building::doors.

  void step_on(RoomIndex room, Vec2 at);
};

/// The rooms as they stand while the wearer walks: furniture, which doors are shut, where their leaves stand. Made room
/// by room when first heard.
class FloorWorld final : public Surroundings {
 public:
  FloorWorld(const FloorPlan& plan, Footprint footprint, const World& world, std::uint64_t seed);

  [[nodiscard]] const View& view_from(RoomIndex room);
  void set_door(std::size_t door, bool open);

  [[nodiscard]] const std::vector<Doorway>& doorways(RoomIndex room) const override;
  [[nodiscard]] const RoomScene& scene(RoomIndex room) override;
  [[nodiscard]] bool is_open(std::size_t door) const override;
  [[nodiscard]] std::optional<Segment> leaf(RoomIndex room, const Doorway& doorway) override;

 private:
  const FloorPlan& plan_;
  const World& world_;
  std::uint64_t seed_;
  Footprint footprint_;
  std::set<std::size_t> shut_;
  std::map<RoomIndex, RoomScene> scenes_;
  std::map<RoomIndex, View> views_;
};

}  // namespace echoway::sim
