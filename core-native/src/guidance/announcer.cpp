#include "guidance/announcer.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/units.hpp"

namespace echoway::guidance {
namespace {

int words_of(CueKind kind) noexcept {
  switch (kind) {
    case CueKind::stop:
      return 1;
    case CueKind::uncertain:
      return 9;
    case CueKind::arrived:
    case CueKind::take_link:
      return 5;
    case CueKind::no_way:
    case CueKind::probe_step:
    case CueKind::entering:
    case CueKind::room_here:
      return 4;
    case CueKind::facing:
    case CueKind::found:
    case CueKind::probe_turn:
    case CueKind::battery_low:
    case CueKind::sensor_blocked:
    case CueKind::stairs:
      return 3;
    default:
      return 2;
  }
}

/// Lines that tell the wearer which way to move.
bool steers(CueKind kind) noexcept {
  return kind == CueKind::turn || kind == CueKind::bear || kind == CueKind::go_straight;
}

/// Lines by which a lost wearer is found again.
bool searches(CueKind kind) noexcept {
  return kind == CueKind::uncertain || kind == CueKind::probe_turn || kind == CueKind::probe_step;
}

/// Lines that whoever asks again wants to hear. A bare "Stop." is none: who stands has done it and
/// asks what came before.
bool instructs(const Cue& cue) noexcept {
  switch (cue.kind) {
    case CueKind::arrived:
    case CueKind::take_link:
      return true;
    default:
      return searches(cue.kind) || steers(cue.kind) || (cue.tail.present && steers(cue.tail.kind));
  }
}

/// What a cue asks the wearer to do, its own or its tail's.
struct Steering {
  bool present = false;
  CueKind kind = CueKind::stop;
  double direction = 0.0;
};
Steering steering_of(const Cue& cue) noexcept {
  if (steers(cue.kind)) return {true, cue.kind, cue.direction};
  if (cue.tail.present && steers(cue.tail.kind)) return {true, cue.tail.kind, cue.tail.direction};
  return {};
}

int side_of(const Steering& s) noexcept {
  const bool sideways = s.kind != CueKind::go_straight && sector_of(s.direction) != Sector::ahead &&
                        sector_of(s.direction) != Sector::behind;
  if (s.kind == CueKind::bear) return s.direction > 0.0 ? 1 : -1;
  if (!sideways) return 0;
  return s.direction > 0.0 ? 1 : -1;
}

/// Lengths that may be rounded to the same words: less than the grain of speech apart.
bool same_length(double a, double b) noexcept {
  if (a < 0.0 || b < 0.0) return a < 0.0 && b < 0.0;
  return std::abs(a - b) < (std::max(a, b) < feet(10.0) ? feet(1.0) : feet(5.0));
}

/// Lines that do not say which one they mean: of two doors one sounds like the other.
bool is_nameless(CueKind kind) noexcept {
  return kind == CueKind::door || kind == CueKind::stairs || kind == CueKind::elevator;
}

bool same_words(const Cue& a, const Cue& b) noexcept {
  if (a.kind == CueKind::found && b.kind == CueKind::found) return a.room == b.room;  // whatever is told besides
  if (a.kind != b.kind || a.room != b.room || a.up != b.up || a.tail.present != b.tail.present) return false;
  if (a.landmark != b.landmark && !is_nameless(a.kind)) return false;
  const bool same_side = a.kind == CueKind::bear ? (a.direction > 0.0) == (b.direction > 0.0)
                                                 : sector_of(a.direction) == sector_of(b.direction);
  if (!same_side || !same_length(a.distance_m, b.distance_m)) return false;
  return !a.tail.present || (a.tail.kind == b.tail.kind && sector_of(a.tail.direction) == sector_of(b.tail.direction) &&
                             same_length(a.tail.distance_m, b.tail.distance_m));
}

}  // namespace

double spoken_seconds(const Cue& cue, const GuideConfig& config) noexcept {
  int words = words_of(cue.kind) + (cue.distance_m >= 0.0 ? 2 : 0) + (cue.count > 0 ? 2 : 0);
  if (cue.tail.present) words += words_of(cue.tail.kind) + (cue.tail.distance_m >= 0.0 ? 2 : 0);
  return config.line_overhead_s + words * config.seconds_per_word;
}

std::size_t Announcer::oldest_that_counts() const noexcept {
  return std::max(waived_, said_count_ - std::min(said_count_, kMemory));
}

bool Announcer::is_way_asked() const noexcept { return again_ && instructed_ && steering_of(instruction_).present; }

void Announcer::take_way_question() noexcept {
  again_ = false;
  waived_ = said_count_;
}

bool Announcer::repeats(const Cue& cue, double now) const noexcept {
  for (std::size_t n = oldest_that_counts(); n < said_count_; ++n) {
    const Cue& said = said_[n % kMemory];
    if (now - said.time_s < config_->repeat_gap_s && same_words(said, cue)) return true;
  }
  return false;
}

bool Announcer::contradicts(const Cue& cue, double now) const noexcept {
  const Steering here = steering_of(cue);
  if (!here.present) return false;
  for (std::size_t n = oldest_that_counts(); n < said_count_; ++n) {
    const Cue& said = said_[n % kMemory];
    if (now - said.time_s >= config_->contradiction_gap_s) continue;
    const Steering before = steering_of(said);
    if (!before.present) continue;
    if (side_of(here) * side_of(before) < 0) return true;
    const bool around = here.kind == CueKind::turn && sector_of(here.direction) == Sector::behind;
    const bool was_around = before.kind == CueKind::turn && sector_of(before.direction) == Sector::behind;
    if (around && before.kind == CueKind::go_straight) return true;
    if (around && was_around) return true;
  }
  return false;
}

bool Announcer::would_speak(const Cue& cue, double now, bool asked) const noexcept {
  if (now < free_at_ && cue.urgency >= speaking_) return false;
  if (asked) return true;
  return !repeats(cue, now) && !contradicts(cue, now);
}

bool Announcer::offer(Cue cue, double now, bool asked) { return say(cue, now, asked, searches(cue.kind)); }

bool Announcer::offer_search(const Cue& cue, double now) { return say(cue, now, false, true); }

bool Announcer::say(Cue cue, double now, bool asked, bool searches) {
  if (!would_speak(cue, now, asked)) return false;
  cue.time_s = now;
  free_at_ = now + spoken_seconds(cue, *config_);
  speaking_ = cue.urgency;
  said_[said_count_ % kMemory] = cue;
  if (instructs(cue)) {
    if (!searches) arrival_.reset();
    else if (instructed_ && instruction_.kind == CueKind::arrived) arrival_ = instruction_;
    instruction_ = cue;
    instructed_ = true;
    searching_ = searches;
  }
  ++said_count_;
  if (size_ == kQueue) {  // Nobody fetches: the oldest line has long gone stale.
    head_ = (head_ + 1) % kQueue;
    --size_;
  }
  queue_[(head_ + size_) % kQueue] = cue;
  ++size_;
  return true;
}

void Announcer::forget_search() noexcept {
  if (!instructed_ || !searching_) return;
  instructed_ = arrival_.has_value();
  instruction_ = arrival_.value_or(Cue{});
  searching_ = false;
  arrival_.reset();
}

void Announcer::answer(double now) {
  if (!again_ || !is_free(now)) return;
  again_ = false;
  if (!instructed_) return;
  Cue cue = instruction_;
  cue.urgency = std::min(cue.urgency, Urgency::asked);
  (void)offer(cue, now, true);
}

bool Announcer::pop(Cue& cue) noexcept {
  if (size_ == 0) return false;
  cue = queue_[head_];
  head_ = (head_ + 1) % kQueue;
  --size_;
  return true;
}

}  // namespace echoway::guidance
