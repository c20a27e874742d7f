#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "echoway/locate/locator.hpp"
#include "guidance/announcer.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// Stairs and elevators on the way: told before, taken, and waited for until the wearer is found on the other level.
class LevelChange {
 public:
  /// REQUIRES: all outlive this.
  LevelChange(const Router& router, const GuideConfig& config, const Way& way)
      : router_(&router), config_(&config), way_(&way) {}

  void forget() noexcept;

  /// Stairs or an elevator `along` metres ahead; once each.
  [[nodiscard]] bool tell(const View& view, const LinePoint& end, double along, Announcer& voice);
  /// "Take the stairs up" to who is there. True while that is all there is to say.
  [[nodiscard]] bool take(const View& view, Announcer& voice);

  /// Whether the wearer has been sent off and is not yet known to have come out.
  [[nodiscard]] bool is_under_way() const noexcept { return landing_ != kNoRoom; }
  /// The wearer, who is under way, asks what to do.
  enum class Asked : std::uint8_t {
    again,  ///< They may not have heard it.
    out,    ///< They are out, on the other level.
    never,  ///< There is nothing to take where they are, though they are thought to be on the level they were to leave.
  };
  [[nodiscard]] Asked ask(const Estimate& estimate) noexcept;
  /// Ends it once they have, or have had the time; true then.
  [[nodiscard]] bool ends(const Estimate& estimate) noexcept;

  /// Echoes need not fit until then.
  [[nodiscard]] double suspended_until() const noexcept { return suspended_until_; }
  [[nodiscard]] std::optional<LevelTransition> take_transition() noexcept {
    return std::exchange(transition_, std::nullopt);
  }
  void drop_transition() noexcept { transition_.reset(); }

 private:
  [[nodiscard]] LevelTransition over(double now) const noexcept;
  [[nodiscard]] bool is_on_level_left(const Estimate& estimate) const noexcept;
  [[nodiscard]] Cue cue_for(CueKind kind, std::int32_t link, const View& view, Vec2 at) const noexcept;

  const Router* router_;
  const GuideConfig* config_;
  const Way* way_;
  std::int32_t told_ = -1;
  double suspended_until_ = -1e300;
  std::int32_t taken_ = -1;      ///< What they were told to take last.
  Estimate told_at_{};           ///< Where the wearer was when they were told to take it,
  bool asked_ = false;           ///< and whether they have asked since.
  RoomIndex landing_ = kNoRoom;  ///< Where they will come out; no room: nobody is under way.
  std::optional<LevelTransition> transition_;
};

}  // namespace echoway::guidance
