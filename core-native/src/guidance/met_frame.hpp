#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "guidance/doorway.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// Who is sent through a doorway and meets its frame, or hears a wall there, stands farther beside it than they are
/// taken to. To which side and how far is weighed over all that was met there; the wearer is led from there, along the
/// wall to the opening, as one who trails it with a hand would find it.
class MetFrame {
 public:
  /// REQUIRES: all outlive this.
  MetFrame(const Router& router, const GuideConfig& config, const HeardSpace& heard)
      : router_(&router), config_(&config), heard_(&heard) {}

  void forget() noexcept {
    door_ = -1;
    met_s_ = -1e300;
  }
  /// The wearer has met something before their chest. True where that may have been the frame of the way's next door:
  /// their place is another one from now on.
  [[nodiscard]] bool meet(const View& view, const Way& way);
  /// The same of who is about to go there, is taken to be right before the opening, and hears a wall there.
  [[nodiscard]] bool hear(const View& view, const Way& way);
  /// Whether the belt hears the next room through the way's next doorway. The wearer stands before it and is to go
  /// `direction` (rad from the chest), about straight through: they are before the opening, for a wall there would
  /// answer sooner.
  [[nodiscard]] bool hears_through(const View& view, const Way& way, double direction) const noexcept;
  /// What was found holds while the place goes on as the wearer does: one that moves although they stand was wrong all
  /// along.
  void watch(const Estimate& estimate, bool walking) noexcept;
  [[nodiscard]] double last_met() const noexcept { return met_s_; }
  /// Where they are by what was met.
  [[nodiscard]] Estimate place(const Estimate& estimate) const noexcept;

 private:
  static constexpr std::size_t kOffsets = 29;
  static constexpr double kGrain = 0.05;  ///< Metres from one offset to the next.
  [[nodiscard]] static constexpr double offset(std::size_t i) noexcept {
    return (static_cast<double>(i) - 0.5 * static_cast<double>(kOffsets - 1)) * kGrain;
  }
  [[nodiscard]] std::optional<Doorway> next_doorway(RoomIndex room, const Way& way) const noexcept;
  void begin(const Doorway& doorway, std::int32_t door, const Estimate& e) noexcept;
  [[nodiscard]] bool hears_wall(const Doorway& doorway, const Pose2& pose, double now) const noexcept;
  [[nodiscard]] bool hears_beyond(const Doorway& doorway, const Pose2& pose, double now) const noexcept;
  void weigh(const Doorway& doorway, const Pose2& taken, double now) noexcept;
  void settle() noexcept;
  /// Whether something is known of that door's frame already, and where the tracker alone has them.
  [[nodiscard]] bool is_known(const Estimate& e, std::int32_t door) const noexcept;
  [[nodiscard]] Pose2 taken_pose(const Estimate& e, std::int32_t door) const noexcept;

  const Router* router_;
  const GuideConfig* config_;
  const HeardSpace* heard_;
  std::int32_t door_ = -1;    ///< Whose frame was met; negative: none.
  RoomIndex room_ = kNoRoom;  ///< From this room,
  double met_s_ = -1e300;     ///< then last.
  Vec2 centre_{};             ///< Of the doorway,
  Vec2 along_{};              ///< and the direction of its wall.
  Vec2 stood_{};              ///< Where the tracker had them when they had just come to a stand,
  double walked_s_ = 1e300;   ///< after they had walked until then.
  /// How likely the wearer is so far along that from where they are taken to be;
  std::array<double, kOffsets> weight_{};
  double aside_ = 0.0;        ///< the likeliest of it.
};

}  // namespace echoway::guidance
