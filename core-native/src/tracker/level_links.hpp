#pragma once

#include <optional>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/random.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// Stairs and elevators: a wearer who comes to one may take it, is on the way for a while, on which no echo fits any
/// room, and then stands at its other end. Empty, and free of cost, in a building of one level.
class LevelLinks {
 public:
  explicit LevelLinks(const Building& building);

  [[nodiscard]] bool none() const noexcept { return ends_.empty(); }

  /// The wearer was told to take a link.
  void expect(const LevelTransition& transition) noexcept { told_ = transition; }

  /// What the wearer was told to take and may still be taking; null when nothing.
  [[nodiscard]] const LevelTransition* expected(double time_s) const noexcept;
  /// Whether a particle stands where that begins, so near that it would be found.
  [[nodiscard]] bool begins_near(const LevelTransition& transition, const Particle& particle) const noexcept;
  /// Whether somebody leads the wearer, who then takes no link unasked but by mistake.
  void lead(bool led) noexcept { led_ = led; }

  /// Whether a particle that is away climbs, and so makes steps.
  [[nodiscard]] bool on_stairs(const Particle& away) const noexcept {
    return ends_[static_cast<std::size_t>(away.link_end)].stairs;
  }

  /// Where a particle that is away may arrive: stairs up and down often begin at one place, and nobody can tell which
  /// was taken before they end. `turn` picks one of the places in turn.
  struct Landing {
    RoomIndex room = kNoRoom;
    Vec2 at{};
    double turn = 0.0;        ///< From the frame of the room that was left into the landing's.
  };
  [[nodiscard]] Landing landing(const Particle& away, std::uint64_t turn) const noexcept;

  /// Lets a particle that stands at a link set out (Gait::away), and one that is away arrive. `turn_known`: whether the
  /// heading was followed meanwhile; otherwise it is anyone's guess at the other end.
  void step(Particle& particle, double time_s, double seconds, bool turn_known, Random& random) const noexcept;
  /// Lets one that is away arrive at once.
  void land(Particle& away, double time_s, bool turn_known, Random& random) const noexcept;

 private:
  struct End {
    std::size_t link = 0;
    RoomIndex room = kNoRoom;
    Vec2 at{};
    RoomIndex to = kNoRoom;
    Vec2 to_at{};
    double turn = 0.0;        ///< From this room's frame into the other's.
    bool stairs = true;
  };
  [[nodiscard]] bool same_place(const End& a, const End& b) const noexcept;
  /// One of the ends that begin where `end` does.
  [[nodiscard]] const End& pick(const End& end, std::uint64_t turn) const noexcept;
  [[nodiscard]] const End& way_taken(const End& end, double time_s, Random& random) const noexcept;
  [[nodiscard]] bool told(const End& end, double time_s) const noexcept;
  [[nodiscard]] double setting_out_rate(const End& end, double time_s) const noexcept;
  [[nodiscard]] bool awaits_word(const Particle& particle, double time_s) const noexcept;
  void arrive(Particle& particle, const End& end, bool turn_known, Random& random) const noexcept;

  std::vector<End> ends_;                   ///< Sorted by room.
  std::vector<std::uint32_t> first_;        ///< Of each room, and one past the last.
  std::optional<LevelTransition> told_;
  bool led_ = false;
};

}  // namespace echoway::tracker
