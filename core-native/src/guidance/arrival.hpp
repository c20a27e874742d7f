#pragma once

#include <cstdint>

#include "guidance/announcer.hpp"
#include "guidance/reaction.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// "You are there": told once, on a place that is known, and taken back by leading on whoever walks on.
class Arrival {
 public:
  /// REQUIRES: all outlive this.
  Arrival(const Router& router, const GuideConfig& config, const Way& way, const Reaction& reaction)
      : router_(&router), config_(&config), way_(&way), reaction_(&reaction) {}

  void forget() noexcept {
    told_at_ = -1.0;
    there_since_ = kNotThere;
    doubted_at_ = -1.0;
  }
  void note_room(const Estimate& estimate) noexcept;

  enum class After : std::uint8_t {
    not_told,
    settling,   ///< It was told and may still be acted upon.
    done,       ///< They stand there.
    walked_on,  ///< They have not taken it in: lead on.
  };
  /// How it goes on after it was told.
  [[nodiscard]] After after(const View& view) noexcept;
  enum class Now : std::uint8_t {
    elsewhere,
    there,        ///< There is nothing else to say.
    doubtful,     ///< The same; once each time they are there by a place that is to be doubted before they are told so.
    walks_past,   ///< They are to stop first: where they are is soon known better then.
  };
  /// Tells it to who is there, or will be when it is said. `holding`: the last instruction is still being carried out.
  [[nodiscard]] Now tell(const View& view, bool holding, Announcer& voice);

 private:
  static constexpr double kNotThere = 1e300;
  [[nodiscard]] bool is_place_known(const View& view) const noexcept;
  [[nodiscard]] bool is_place_sharp(const View& view) const noexcept;
  [[nodiscard]] bool is_there(const View& view, bool holding) const;
  [[nodiscard]] bool walks_past(const View& view) const;
  [[nodiscard]] bool comes_to_a_stand(const View& view, bool holding) const noexcept;
  [[nodiscard]] bool has_stood_doubt(double now) const noexcept;
  [[nodiscard]] Cue cue_for(const Pose2& pose) const;

  const Router* router_;
  const GuideConfig* config_;
  const Way* way_;
  const Reaction* reaction_;
  RoomIndex room_ = kNoRoom;   ///< The wearer is in this room
  double room_since_ = -1e300; ///< since then.
  double pace_ = 0.0;          ///< At which they walked last, m/s.
  double told_at_ = -1.0;      ///< Negative before.
  double doubted_at_ = -1.0;   ///< When the place was doubted; negative: not yet.
  double there_since_ = kNotThere;  ///< They have been at the destination since then.
};

}  // namespace echoway::guidance
