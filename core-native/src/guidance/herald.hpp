#pragma once

#include "guidance/level_change.hpp"
#include "guidance/reaction.hpp"

namespace echoway::guidance {

/// Tells what comes on the way while nothing has to be done: a narrow stretch, the next door, stairs or an elevator.
class Herald {
 public:
  /// REQUIRES: all outlive this.
  Herald(const Router& router, const GuideConfig& config, const Way& way, const Reaction& reaction, LevelChange& levels)
      : router_(&router), config_(&config), way_(&way), reaction_(&reaction), levels_(&levels) {}

  void forget() noexcept;
  /// A door that the way no longer leads through may be told again.
  void note_way() noexcept;
  /// Offers at most one line.
  void tell(const View& view, Announcer& voice);

 private:
  [[nodiscard]] bool tell_narrow(const View& view, Announcer& voice);
  void tell_door(const View& view, const LinePoint& door, double along, Announcer& voice);

  const Router* router_;
  const GuideConfig* config_;
  const Way* way_;
  const Reaction* reaction_;
  LevelChange* levels_;
  std::int32_t told_door_ = -1;
  bool told_narrow_ = false;
};

}  // namespace echoway::guidance
