#include "guidance/search.hpp"

#include <cmath>

#include "guidance/probe.hpp"

namespace echoway::guidance {

void Search::begin() noexcept {
  on_ = true;
  told_ = false;
  since_ = -1.0;
  last_request_ = -1e300;
}

bool Search::update(const Estimate& e, std::span<const Hypothesis> places, bool starting, bool asked, Announcer& voice) {
  constexpr double kStartPatience = 3.0;  // s
  const double now = e.time_s;
  if (!on_ || since_ < 0.0) since_ = now;
  on_ = true;
  if (starting && now - since_ < kStartPatience && !asked) return false;
  if (!told_ || asked) return tell_uncertain(now, asked, voice);
  if (stop_before_echo(e, voice)) return false;
  if (now - last_request_ < (turned_last_ ? config_->probe_gap_s : config_->step_gap_s)) return false;
  const Cue cue = next_request(now, places);
  if (!voice.offer(cue, now)) return false;
  last_request_ = now;
  turned_last_ = cue.kind == CueKind::probe_turn;
  if (!turned_last_) step_direction_ = wrap_angle(cue.direction + turning_->turned());
  return false;
}

bool Search::tell_uncertain(double now, bool asked, Announcer& voice) {
  if (!voice.offer(make_cue(CueKind::uncertain), now, asked)) return false;
  told_ = turned_last_ = true;
  last_request_ = now;
  return true;
}

/// Who is lost and walks on all the same is kept from what the belt hears before them.
bool Search::stop_before_echo(const Estimate& e, Announcer& voice) const {
  constexpr double kWalks = 0.4;   // m/s
  constexpr double kMargin = 0.3;  // metres
  const double speed = std::isfinite(e.speed_mps) ? e.speed_mps : 0.0;
  if (speed < kWalks) return false;
  const auto echo = heard_->ahead(e.time_s);
  const Cue stop = make_cue(CueKind::stop);
  const double needed = config_->body_m + kMargin + speed * (spoken_seconds(stop, *config_) + config_->reaction_s);
  return echo && *echo < needed && voice.offer(stop, e.time_s);
}

/// Turning on the spot shows the same walls again and again: every other time it is a step to where the belt hears that it
/// is free, once the wearer stands still.
Cue Search::next_request(double now, std::span<const Hypothesis> places) const {
  constexpr double kStepFree = 1.0;  // metres from the wearer's middle
  constexpr double kStill = 1.2;     // s: directions that were heard hold
  Probe probe = choose_probe(*router_, config_->belt, places);
  const bool still = turning_->still_for(kStill, now);
  if (probe.action == Probe::Action::step && !(still && heard_->is_free(probe.direction, kStepFree, now))) {
    probe = {Probe::Action::turn, kPi / 2, 0.0};
  }
  if (probe.action == Probe::Action::turn && turned_last_ && still) {
    // On the way that the last step went, however the wearer has turned since: to and fro shows nothing new.
    const double onward = wrap_angle(step_direction_ - turning_->turned());
    if (const auto free = heard_->most_free(kStepFree, onward, now)) probe = {Probe::Action::step, *free, 0.0};
  }
  Cue cue = make_cue(probe.action == Probe::Action::turn ? CueKind::probe_turn : CueKind::probe_step);
  cue.direction = probe.direction;
  cue.has_direction = true;
  return cue;
}

}  // namespace echoway::guidance
