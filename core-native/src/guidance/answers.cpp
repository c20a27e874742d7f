#include "guidance/answers.hpp"

#include "guidance/surroundings.hpp"

namespace echoway::guidance {
void Answers::start_over(bool leading) noexcept {
  where_ = where_ || is_answering();
  count_ = next_ = 0;
  destination_ = leading;
}

void Answers::tell_destination(const Estimate& e, const Route* route, Announcer& voice) {
  if (route == nullptr) {
    destination_ = false;
    return;
  }
  if (route->waypoints.empty()) return;  // no way yet
  Cue cue = make_cue(CueKind::destination);
  cue.sigma_m = e.sigma_m;
  cue.distance_m = walked_length(*route);
  cue.landmark = landmark_of(route->goal);
  if (cue.landmark.kind == CueLandmark::Kind::none || voice.offer(cue, e.time_s, true)) destination_ = false;
}

void Answers::gather_where(const Estimate& e) {
  where_ = false;
  lines_[0] = room_cue(CueKind::room_here, e.room);
  lines_[1] = facing(*router_, e);
  lines_[2] = nearest_door(*router_, e);
  lines_[2].urgency = Urgency::asked;
  count_ = lines_[2].distance_m >= 0.0 ? 3 : 2;
  next_ = 0;
  asked_at_ = e.time_s;
}

void Answers::tell(const Estimate& e, const Route* route, Announcer& voice) {
  constexpr double kWorthTelling = 12.0;  // s after it was asked
  if (destination_) tell_destination(e, route, voice);
  if (where_) gather_where(e);
  if (!is_answering()) return;
  if (e.time_s - asked_at_ > kWorthTelling) next_ = count_;
  else if (voice.is_free(e.time_s) && voice.offer(lines_[next_], e.time_s, true)) ++next_;
}

}  // namespace echoway::guidance
