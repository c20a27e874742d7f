#include "tracker/search.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tracker/elementary.hpp"
#include "tracker/floor.hpp"

namespace echoway::tracker {
namespace {

constexpr double kBodyClearance = 0.12;   // Nobody's axis comes nearer to a wall, metres.
constexpr double kNowhere = -1e300;
constexpr double kStandingShare = 0.4;    // Of wearers who do not know where they are.
constexpr double kDrawnSpeedSigma = 0.15; // Metres a second.
constexpr double kCellSigma = 0.45;       // Standard deviation of a place within its cell, as a share of the cell's width,
constexpr double kRefinedSigma = 0.25;    // and of one drawn from it.

bool less_likely_on_top(double a, double b) noexcept { return a > b; }

double replay(Particle& p, const Record& record, const Search::Tools& tools, bool coarse) noexcept {
  advance_mean(p, record.interval, tools.motion);
  const double bearing = tools.belt.bearing(record.sensor);
  const SinCos b = fast_sincos(bearing);
  Shot shot;
  shot.bearing = {b.cos, b.sin};
  shot.sensor = record.sensor;
  shot.bearing_rad = bearing;
  shot.radius = tools.belt.radius_m;
  shot.range = record.range;
  shot.echo = record.echo;
  shot.coarse = coarse;
  shot.trust = record.trust;
  const double density = record.trust > 0.0 ? assimilate(p, shot, tools.model, tools.scene).density : 1.0;
  return record.novelty * fast_log(density) + fast_log(std::max(1e-9, settle_on_floor(p, tools.scene)));
}

}  // namespace

Search::Search(const scene::Scene& scene, const Parameters& parameters) : parameters_(parameters) {
  survivors_.resize(parameters_.keep);
  refined_.resize(parameters_.refined);
  for (std::size_t r = 0; r < scene.room_count(); ++r) {
    const auto& room = scene.room(static_cast<RoomIndex>(r));
    area_ += (room.high.x - room.low.x) * (room.high.y - room.low.y);
  }
  const double headings = kTwoPi / parameters_.heading_step;
  const auto spacing_for = [&](double candidates) { return std::sqrt(area_ * headings / candidates); };
  spacing_ = std::clamp(spacing_for(parameters_.few_candidates), parameters_.closest_spacing, parameters_.spacing);
  spacing_ = std::max(spacing_, spacing_for(static_cast<double>(parameters_.most_candidates)));
}

void Search::start(SearchDomain domain, std::uint64_t begin, std::uint64_t end) noexcept {
  phase_ = Phase::sweeping;
  domain_ = domain;
  begin_ = begin;
  end_ = end;
  room_ = domain.only_room == kNoRoom ? 0 : domain.only_room;
  columns_ = 0;
  tried_ = count_ = refined_count_ = cursor_ = 0;
  best_.fill(kNowhere);
  turns_ = heading_is_known() ? 5 : static_cast<int>(std::lround(kTwoPi / parameters_.heading_step));
}

void Search::enter_room(const Tools& tools) noexcept {
  const auto& room = tools.scene.room(room_);
  centre_ = domain_.heading;
  if (domain_.level_heading) centre_ = *domain_.level_heading - tools.building.room(room_).frame.heading;
  if (domain_.near_heading) {
    centre_ = *domain_.near_heading + tools.building.room(domain_.near_room).frame.heading - tools.building.room(room_).frame.heading;
  }
  const Vec2 size = room.high - room.low;
  columns_ = std::max(1, static_cast<int>(std::ceil(size.x / spacing_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(size.y / spacing_)));
  origin_ = room.low + 0.5 * Vec2{size.x - spacing_ * (columns_ - 1), size.y - spacing_ * (rows_ - 1)};
  column_ = row_ = turn_ = 0;
  floor_checked_ = false;
}

// Whether any of the current room lies within the domain, by its bounding box. The levels above and below count as near:
// somebody may have taken the stairs unnoticed.
bool Search::reachable(const Tools& tools) const noexcept {
  if (!domain_.within) return true;
  const auto& room = tools.scene.room(room_);
  const Room& here = tools.building.room(room_);
  const Room& near = tools.building.room(domain_.near_room);
  const Vec2 centre = here.frame.inverse_transform(near.frame.transform(domain_.near_position));
  const Vec2 closest{std::clamp(centre.x, room.low.x, room.high.x), std::clamp(centre.y, room.low.y, room.high.y)};
  return distance(centre, closest) <= *domain_.within;
}

bool Search::worth_trying(const Tools& tools, Vec2 position) const noexcept {
  if (domain_.within) {
    const Room& near = tools.building.room(domain_.near_room);
    const Room& here = tools.building.room(room_);
    if (distance(here.frame.transform(position), near.frame.transform(domain_.near_position)) > *domain_.within) return false;
  }
  const auto& floor = tools.scene.room(room_).floor;
  return floor.contains(position) && floor.distance(position) > kBodyClearance;
}

bool Search::next_candidate(const Tools& tools, Vec2& position, double& heading) noexcept {
  for (;;) {
    if (columns_ == 0) {
      if (room_ >= static_cast<RoomIndex>(tools.scene.room_count())) return false;
      enter_room(tools);
      if (!reachable(tools)) row_ = rows_;
    }
    while (row_ < rows_) {
      position = origin_ + Vec2{spacing_ * column_, spacing_ * row_};
      if (!floor_checked_) {
        floor_checked_ = worth_trying(tools, position);
        if (!floor_checked_) turn_ = turns_;
      }
      if (turn_ < turns_) {
        heading = centre_ ? *centre_ + domain_.heading_sigma * (turn_ - 0.5 * (turns_ - 1))
                          : -kPi + parameters_.heading_step * (turn_ + 0.5);
        ++turn_;
        return true;
      }
      turn_ = 0;
      floor_checked_ = false;
      if (++column_ == columns_) {
        column_ = 0;
        ++row_;
      }
    }
    columns_ = 0;
    if (domain_.only_room != kNoRoom) return false;
    ++room_;
  }
}

void Search::keep(const Survivor& survivor) noexcept {
  const auto order = [](const Survivor& a, const Survivor& b) { return less_likely_on_top(a.log_likelihood, b.log_likelihood); };
  const auto first = survivors_.begin();
  if (count_ < survivors_.size()) {
    survivors_[count_++] = survivor;
    std::push_heap(first, first + static_cast<std::ptrdiff_t>(count_), order);
  } else if (survivor.log_likelihood > survivors_.front().log_likelihood) {
    std::pop_heap(first, survivors_.end(), order);
    survivors_.back() = survivor;
    std::push_heap(first, survivors_.end(), order);
  }
}

Particle Search::candidate(const Tools& tools, RoomIndex room, Vec2 position, double heading, double sigma) const noexcept {
  Particle p;
  p.room = room;
  p.position = position;
  p.heading = wrap_near(heading);
  const SinCos f = fast_sincos(p.heading);
  p.facing = {f.cos, f.sin};
  p.speed = tools.motion.start_speed;
  p.gyro_bias = tools.gyro_bias;
  p.log_scale = tools.log_scale;
  p.cov.xx = p.cov.yy = sigma * sigma;
  p.cov.ss = tools.motion.start_speed_sigma * tools.motion.start_speed_sigma;
  p.cov.kk = tools.log_scale_sigma * tools.log_scale_sigma;
  return p;
}

std::size_t Search::try_candidate(const Tools& tools, Vec2 position, double heading) noexcept {
  Particle p = candidate(tools, room_, position, heading, kCellSigma * spacing_);
  Survivor s{room_, position, heading, 0.0};
  std::size_t spent = 0;
  for (std::uint64_t n = begin_; n < end_; ++n) {
    const std::size_t at = static_cast<std::size_t>(n - begin_);
    s.log_likelihood += replay(p, from_begin(tools.history, n), tools, true);
    ++spent;
    if (at < kCheckpoints) {
      if (s.log_likelihood < best_[at] - parameters_.give_up) return spent;
      best_[at] = std::max(best_[at], s.log_likelihood);
    }
  }
  keep(s);
  return spent;
}

Record Search::from_begin(const History& history, std::uint64_t number) const noexcept {
  Record record = history[number];
  if (number == begin_) record.interval = {};
  return record;
}

bool Search::work(const Tools& tools, Random& random) noexcept {
  std::size_t spent = 0;
  while (phase_ == Phase::sweeping && spent < budget()) {
    Vec2 position;
    double heading = 0.0;
    if (!next_candidate(tools, position, heading)) {
      draw_from_survivors(tools, random);
      phase_ = Phase::refining;
      break;
    }
    ++tried_;
    const std::size_t compiled = tools.scene.cells_compiled();
    spent += try_candidate(tools, position, heading);
    spent += parameters_.cell_cost * (tools.scene.cells_compiled() - compiled);
  }
  return phase_ == Phase::refining && spent < budget() && refine(tools, budget() - spent);
}

// Systematic resampling keeps neighbours' joint weight to within one particle when neighbours stand side by side (Kitagawa
// 1996): places that no echo tells apart, as along a hall, then do not die out by chance.
void Search::in_order_of_place() noexcept {
  std::sort(survivors_.begin(), survivors_.begin() + static_cast<std::ptrdiff_t>(count_), [](const Survivor& a, const Survivor& b) {
    return std::tie(a.room, a.position.x, a.position.y, a.heading) < std::tie(b.room, b.position.x, b.position.y, b.heading);
  });
}

// Survivors are drawn by the root of their likelihood: a coarse one is not to be trusted fully.
void Search::draw_from_survivors(const Tools& tools, Random& random) noexcept {
  cursor_ = refined_count_ = 0;
  if (count_ == 0) return;
  in_order_of_place();
  double best = kNowhere;
  for (std::size_t i = 0; i < count_; ++i) best = std::max(best, survivors_[i].log_likelihood);
  const auto flattened = [&](std::size_t i) { return fast_exp(0.5 * (survivors_[i].log_likelihood - best)); };
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += flattened(i);
  refined_count_ = is_local() ? parameters_.refined_locally : parameters_.refined;
  const double step = sum / static_cast<double>(refined_count_);
  double at = random.uniform() * step;
  double reached = flattened(0);
  std::size_t i = 0;
  for (std::size_t n = 0; n < refined_count_; ++n, at += step) {
    while (reached < at && i + 1 < count_) reached += flattened(++i);
    const Survivor& s = survivors_[i];
    const Vec2 off{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double heading = s.heading + random.uniform(-0.5, 0.5) * heading_cell();
    refined_[n].particle = candidate(tools, s.room, s.position + spacing_ * off, heading, kRefinedSigma * spacing_);
    Particle& p = refined_[n].particle;
    p.gait = random.uniform() < kStandingShare ? Gait::standing : Gait::walking;
    p.speed = p.gait == Gait::standing ? 0.0 : tools.motion.start_speed + tools.motion.start_speed_sigma * cheap_normal(random);
    const double sigma = p.gait == Gait::standing ? tools.motion.standing_sigma : kDrawnSpeedSigma;
    p.cov.ss = sigma * sigma;
    // Prior over proposal.
    refined_[n].log_weight = fast_log(sum) - 0.5 * (s.log_likelihood - best);
    refined_[n].next = begin_;
  }
}

bool Search::refine(const Tools& tools, std::size_t budget) noexcept {
  const auto bring_up = [&](Refined& r) {
    std::size_t spent = 0;
    for (; r.next < tools.history.end(); ++r.next, ++spent) {
      r.log_weight += replay(r.particle, from_begin(tools.history, r.next), tools, false);
    }
    return spent;
  };
  std::size_t spent = 0;
  for (; cursor_ < refined_count_ && spent < budget; ++cursor_) spent += bring_up(refined_[cursor_]);
  if (cursor_ < refined_count_) return false;
  // Those that were brought up in earlier slices may lag a few firings behind.
  for (std::size_t i = 0; i < refined_count_; ++i) bring_up(refined_[i]);
  finish(tools);
  return true;
}

// A tracker that lost its hold is most often not far off; being carried elsewhere is rare.
double Search::log_prior(const Particle& p, const Building& building) const noexcept {
  if (domain_.near_room == kNoRoom || domain_.within) return 0.0;
  constexpr double kNearSigma = 2.0;
  constexpr double kNearShare = 0.9997;
  const Room& here = building.room(p.room);
  const Room& near = building.room(domain_.near_room);
  double nearness = 0.0;
  if (here.level == near.level) {
    const double d2 = squared_norm(here.frame.transform(p.position) - near.frame.transform(domain_.near_position));
    nearness = area_ / (kTwoPi * kNearSigma * kNearSigma) * fast_exp(-0.5 * d2 / (kNearSigma * kNearSigma));
  }
  return fast_log(kNearShare * nearness + 1.0 - kNearShare);
}

void Search::finish(const Tools& tools) noexcept {
  phase_ = Phase::done;
  double best = kNowhere;
  for (std::size_t i = 0; i < refined_count_; ++i) {
    refined_[i].log_weight += log_prior(refined_[i].particle, tools.building);
    best = std::max(best, refined_[i].log_weight);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < refined_count_; ++i) {
    refined_[i].particle.weight = fast_exp(refined_[i].log_weight - best);
    sum += refined_[i].particle.weight;
  }
  const double drawn = static_cast<double>(std::max<std::size_t>(refined_count_, 1));
  log_evidence_ = sum > 0.0 ? best + fast_log(sum / drawn) - fast_log(static_cast<double>(std::max<std::size_t>(tried_, 1))) : kNowhere;
}

void Search::take(Population& out, Random& random, const MotionParameters& motion) noexcept {
  phase_ = Phase::idle;
  out.clear();
  for (std::size_t i = 0; i < refined_count_; ++i) out.push(refined_[i].particle);
  if (out.empty()) return;
  out.normalize();
  out.resample(out.size(), random);
  for (Particle& p : out.particles()) {
    p.gyro_bias += motion.gyro_bias_sigma * cheap_normal(random);
  }
}

}  // namespace echoway::tracker
