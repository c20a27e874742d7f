#pragma once

#include "cue_collector.hpp"
#include "echoway/session.hpp"

namespace echoway::tools {

/// Prints, line by line, what a live wearer hears as it is spoken, and where they are once a second and at every
/// change.
class LiveReport {
 public:
  LiveReport(Session& session, const SpeechStyle& style) : session_(session), voice_(session, style) {}
  void update();
  /// What the belt has sent so far, and what of it was dropped.
  void print_belt() const;

 private:
  void print_cues();
  void print_position();

  Session& session_;
  CueCollector voice_;
  RoomIndex room_ = kNoRoom;
  TrackState state_ = TrackState::searching;
  double printed_at_ = -1e300;
};

}  // namespace echoway::tools
