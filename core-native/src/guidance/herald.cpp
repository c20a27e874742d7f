#include "guidance/herald.hpp"

#include <algorithm>

#include "guidance/surroundings.hpp"

namespace echoway::guidance {

void Herald::forget() noexcept {
  told_door_ = -1;
  told_narrow_ = false;
}

void Herald::note_way() noexcept {
  if (told_door_ >= 0 && !way_->leads_through(told_door_)) told_door_ = -1;
}

bool Herald::tell_narrow(const View& view, Announcer& voice) {
  if (told_narrow_ || !way_->route().narrow(router_->config())) return false;
  told_narrow_ = voice.offer(make_cue(CueKind::narrow), view.now);
  return true;
}

void Herald::tell_door(const View& view, const LinePoint& door, double along, Announcer& voice) {
  Cue cue = make_cue(CueKind::door);
  cue.distance_m = along;
  cue.sigma_m = view.estimate->sigma_m;
  cue.direction = direction_to(view.estimate->pose, door.at);
  cue.has_direction = true;
  cue.landmark = {CueLandmark::Kind::door, door.index};
  const double needed = reaction_->way(cue, view.speed);
  const double until = view.turn.present ? std::min(along, view.turn.distance) : along;
  const double turn_lead = view.turn.present ? view.speed * 2.0 : 0.0;
  if (told_door_ == door.index || until < needed + turn_lead) return;
  if (voice.offer(cue, view.now)) told_door_ = door.index;
}

void Herald::tell(const View& view, Announcer& voice) {
  if (view.vague || !voice.is_free(view.now) || tell_narrow(view, voice)) return;
  const auto line = way_->line();
  double along = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    along += distance(line[i - 1].at, line[i].at);
    if (along > config_->door_cue_m) return;
    if (line[i].kind == WaypointKind::link_from) {
      (void)levels_->tell(view, line[i], along, voice);
      return;
    }
    if (line[i].kind == WaypointKind::door) {
      tell_door(view, line[i], along, voice);
      return;
    }
  }
}

}  // namespace echoway::guidance
