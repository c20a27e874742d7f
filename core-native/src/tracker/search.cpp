#include "tracker/search.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tracker/elementary.hpp"
#include "tracker/twins.hpp"

namespace echoway::tracker {
namespace {

constexpr double kFlattening = 0.5;       // Power of the sweep's likelihoods to draw survivors by: it is coarse.
constexpr double kNowhere = -1e300;
constexpr double kStandingShare = 0.4;    // Of wearers who do not know where they are.
constexpr double kDrawnSpeedSigma = 0.15; // Metres a second.
constexpr double kCellSigma = 0.45;       // Standard deviation of a place within its cell, as a share of its width,
constexpr double kRefinedSigma = 0.25;    // and of one drawn from it.

double area_of(const scene::Scene& scene) noexcept {
  double area = 0.0;
  for (std::size_t r = 0; r < scene.room_count(); ++r) area += scene.room(static_cast<RoomIndex>(r)).box_area();
  return area;
}

double spacing_for(double area, const Search::Parameters& p) noexcept {
  const double headings = kTwoPi / p.heading_step;
  const auto spacing_of = [&](double candidates) { return std::sqrt(area * headings / candidates); };
  const double spacing = std::clamp(spacing_of(p.few_candidates), p.closest_spacing, p.spacing);
  return std::max(spacing, spacing_of(static_cast<double>(p.most_candidates)));
}

}  // namespace

Search::Search(const scene::Scene& scene, const Parameters& parameters)
    : parameters_(parameters),
      hopeless_(fast_exp(-parameters.give_up)),
      area_(area_of(scene)),
      grid_(spacing_for(area_, parameters)),
      refinement_(std::max(parameters.refined, parameters.refined_thoroughly)) {
  survivors_.resize(parameters_.keep);
  slice_ = std::clamp(area_ / parameters_.usual_area, 1.0, parameters_.largest_slice);
}

// Of many more places more fit a pass by chance.
std::uint64_t Search::firings_to_tell(const SearchDomain& domain, int sensors) const noexcept {
  constexpr int kFewest = 8;
  constexpr int kMost = static_cast<int>(kMostSwept);
  return static_cast<std::uint64_t>(is_large(domain) ? kMost : std::clamp(sensors, kFewest, kMost));
}

std::size_t Search::budget() const noexcept {
  if (domain_.near_heading) return parameters_.local_budget;
  const std::size_t usual = domain_.near_room == kNoRoom ? parameters_.budget : parameters_.second_budget;
  return is_large(domain_) ? static_cast<std::size_t>(slice_ * static_cast<double>(usual)) : usual;
}

void Search::start(SearchDomain domain, std::uint64_t begin, std::uint64_t end) noexcept {
  phase_ = Phase::sweeping;
  domain_ = domain;
  begin_ = begin;
  end_ = end;
  grid_.start(domain);
  tried_ = count_ = swept_ = 0;
  best_.fill(0.0);
  turn_ = turns_ = heading_is_known() ? 5 : static_cast<int>(std::lround(kTwoPi / parameters_.heading_step));
}

std::optional<double> Search::heading_in_room(const Building& building) const noexcept {
  const double frame = building.room(grid_.room()).frame.heading;
  if (domain_.near_heading) return *domain_.near_heading + building.room(domain_.near_room).frame.heading - frame;
  if (domain_.level_heading) return *domain_.level_heading - frame;
  return domain_.heading;
}

bool Search::next_candidate(const SearchTools& tools, double& heading) noexcept {
  if (turn_ == turns_) {
    if (!grid_.next(tools, domain_)) return false;
    turn_ = 0;
    centre_ = heading_in_room(tools.building);
    panorama_.stand_at(tools.scene.room(grid_.room()), grid_.position());
  }
  heading = centre_ ? *centre_ + domain_.heading_sigma * (turn_ - 0.5 * (turns_ - 1))
                    : -kPi + parameters_.heading_step * turn_;
  ++turn_;
  return true;
}

void Search::keep(const Survivor& survivor) noexcept {
  // The least likely on top. Which of two equals a heap drops is its library's own affair, so that none may be equal.
  const auto order = [](const Survivor& a, const Survivor& b) {
    return a.log_likelihood != b.log_likelihood ? a.log_likelihood > b.log_likelihood : a.lot > b.lot;
  };
  const auto first = survivors_.begin();
  if (count_ < survivors_.size()) {
    survivors_[count_++] = survivor;
    std::push_heap(first, first + static_cast<std::ptrdiff_t>(count_), order);
  } else if (order(survivor, survivors_.front())) {
    std::pop_heap(first, survivors_.end(), order);
    survivors_.back() = survivor;
    std::push_heap(first, survivors_.end(), order);
  }
}

Particle Search::candidate(const SearchTools& tools, RoomIndex room, Vec2 position, double heading,
                           double sigma) const noexcept {
  Particle p;
  p.room = room;
  p.position = position;
  p.heading = wrap_near(heading);
  face_heading(p);
  p.speed = tools.motion.start_speed;
  p.gyro_bias = tools.gyro_bias;
  p.log_scale = tools.log_scale;
  p.cov.xx = p.cov.yy = sigma * sigma;
  p.cov.ss = tools.motion.start_speed_sigma * tools.motion.start_speed_sigma;
  p.cov.kk = tools.log_scale_sigma * tools.log_scale_sigma;
  return p;
}

// The way since the window began, by what the gyroscope says and at one metre a second: the same for all candidates.
void Search::reckon(const SearchTools& tools) noexcept {
  const std::uint64_t end = begin_ + window();
  swept_ = 0;
  double turn = 0.0, seconds = 0.0;
  Vec2 way{};
  for (std::uint64_t n = begin_; n < end; ++n) {
    const Record record = from_begin(tools.history, n);
    const double dt = record.interval.seconds;
    const double turned = record.interval.turn_known ? record.interval.turn_without(tools.gyro_bias) : 0.0;
    const SinCos mid = fast_sincos(wrap_near(turn + 0.5 * turned));
    way = way + dt * Vec2{mid.cos, mid.sin};
    turn = wrap_near(turn + turned);
    seconds += dt;
    if (record.trust > 0.0) {
      legs_[swept_++] = {way, turn + tools.belt.bearing(record.sensor), seconds,
                         record.range, record.novelty, record.echo, record.log_main};
    }
  }
}

// They tell places apart sooner than silence does, so that hopeless candidates are dropped after fewer looks.
void Search::put_echoes_first() noexcept {
  const auto in_order_of_time = legs_;
  std::size_t at = 0;
  for (const bool echo : {true, false}) {
    for (std::size_t i = 0; i < swept_; ++i) {
      if (in_order_of_time[i].echo == echo) legs_[at++] = in_order_of_time[i];
    }
  }
}

// What a search against a belief finds is worth nothing unless it beats the belief: that runs as a candidate.
void Search::enter_belief() noexcept {
  if (!domain_.least_gain) return;
  log_belief_ = 0.0;
  for (std::size_t i = 0; i < swept_; ++i) {
    log_belief_ += legs_[i].log_belief;
    best_[i] = fast_exp(log_belief_);
  }
}

bool Search::beats_belief() const noexcept {
  if (!domain_.least_gain) return true;
  const auto beats = [&](const Survivor& s) { return s.log_likelihood >= log_belief_ + *domain_.least_gain; };
  return std::any_of(survivors_.begin(), survivors_.begin() + static_cast<std::ptrdiff_t>(count_), beats);
}

double Search::likelihood(const SearchTools& tools, const Leg& leg, const SinCos& facing, double heading,
                          const scene::Cell& seen) noexcept {
  const double cell_sigma = kCellSigma * grid_.spacing();
  Offset offset;
  offset.per_speed = rotated(leg.way, {facing.cos, facing.sin});
  offset.moved = tools.motion.start_speed * offset.per_speed;
  offset.speed_variance = tools.motion.start_speed_sigma * tools.motion.start_speed_sigma;
  offset.variance = cell_sigma * cell_sigma + tools.motion.sway * tools.motion.sway * leg.seconds;
  offset.log_scale = tools.log_scale;
  offset.log_scale_variance = tools.log_scale_sigma * tools.log_scale_sigma;
  const Panorama::Sight& sight = panorama_.towards(heading + leg.bearing, tools.belt.radius_m, tools.model, seen);
  return tempered(density_of(sight, leg.echo, leg.range, offset, tools.model), leg.novelty);
}

std::size_t Search::try_candidate(const SearchTools& tools, double heading) noexcept {
  const scene::Cell& seen = grid_.seen(tools);
  const SinCos facing = fast_sincos(wrap_near(heading));
  constexpr std::uint64_t kScatter = 0x9e3779b97f4a7c15;  // Odd, so that all products differ; equals are kept all over.
  const std::size_t looks = panorama_.looks();
  double so_far = 1.0;
  std::size_t n = 0;
  for (; n < swept_; ++n) {
    so_far *= likelihood(tools, legs_[n], facing, heading, seen);
    if (so_far < hopeless_ * best_[n]) break;
    best_[n] = std::max(best_[n], so_far);
  }
  if (n == swept_) keep({grid_.room(), grid_.position(), heading, fast_log(so_far), tried_ * kScatter});
  return n + parameters_.look_cost * (panorama_.looks() - looks);
}

Record Search::from_begin(const History& history, std::uint64_t number) const noexcept {
  Record record = history[number];
  if (number == begin_) record.interval = {};
  return record;
}

bool Search::work(const SearchTools& tools, Random& random) noexcept {
  std::size_t spent = 0;
  grid_.forget_seen();
  if (swept_ == 0) {
    reckon(tools);
    put_echoes_first();
    enter_belief();
  }
  while (phase_ == Phase::sweeping && spent < budget()) {
    double heading = 0.0;
    if (!next_candidate(tools, heading)) {
      if (!beats_belief()) {
        phase_ = Phase::done;
        log_evidence_ = kNowhere;
        return true;
      }
      draw_from_survivors(tools, random);   // Which fills the slice.
      phase_ = Phase::refining;
      return false;
    }
    ++tried_;
    const std::size_t compiled = tools.scene.compile_work();
    spent += try_candidate(tools, heading);
    spent += parameters_.compile_cost * (tools.scene.compile_work() - compiled);
  }
  if (phase_ != Phase::refining || spent >= budget()) return false;
  const std::size_t replays = (budget() - spent) / parameters_.replay_cost + 1;
  if (!refinement_.work(tools, random, replays, parameters_.replay_cost / parameters_.compile_cost)) return false;
  // Taking over what was found costs a firing's time as well: it waits for one with little left to catch up with.
  const std::size_t a_firing = refinement_.population().size();
  if (refinement_.spent() > a_firing) return false;
  finish(tools);
  return true;
}

// Systematic resampling keeps neighbours' joint weight to within one particle when neighbours stand side by side
// (Kitagawa 1996): places that no echo tells apart, as along a hall, then do not die out by chance.
void Search::in_order_of_place() noexcept {
  const auto end = survivors_.begin() + static_cast<std::ptrdiff_t>(count_);
  std::sort(survivors_.begin(), end, [](const Survivor& a, const Survivor& b) {
    return std::tie(a.room, a.position.x, a.position.y, a.heading) <
           std::tie(b.room, b.position.x, b.position.y, b.heading);
  });
}

void Search::draw_from_survivors(const SearchTools& tools, Random& random) noexcept {
  refinement_.begin(begin_, window(), looks_all_over());
  if (count_ == 0) return;
  in_order_of_place();
  double best = kNowhere;
  for (std::size_t i = 0; i < count_; ++i) best = std::max(best, survivors_[i].log_likelihood);
  const auto flattened = [&](std::size_t i) { return fast_exp(kFlattening * (survivors_[i].log_likelihood - best)); };
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) sum += flattened(i);
  const MotionParameters& motion = tools.motion;
  const std::size_t drawn = to_draw();
  const double step = sum / static_cast<double>(drawn);
  double at = random.uniform() * step;
  double reached = flattened(0);
  std::size_t i = 0;
  for (std::size_t n = 0; n < drawn; ++n, at += step) {
    while (reached < at && i + 1 < count_) reached += flattened(++i);
    const Survivor& s = survivors_[i];
    const Vec2 off{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double heading = s.heading + random.uniform(-0.5, 0.5) * heading_cell();
    Particle p = candidate(tools, s.room, s.position + grid_.spacing() * off, heading, kRefinedSigma * grid_.spacing());
    p.gait = random.uniform() < kStandingShare ? Gait::standing : Gait::walking;
    p.speed = p.gait == Gait::standing ? 0.0 : motion.start_speed + motion.start_speed_sigma * cheap_normal(random);
    const double sigma = p.gait == Gait::standing ? motion.standing_sigma : kDrawnSpeedSigma;
    p.cov.ss = sigma * sigma;
    p.weight = step;
    p.foreseen = fast_exp(-kFlattening * (s.log_likelihood - best) / static_cast<double>(window()));
    p.gyro_bias += motion.gyro_bias_sigma * cheap_normal(random);
    refinement_.population().push(p);
  }
  log_evidence_ = 0.0;
}

// A tracker that lost its hold is most often not far off; being carried elsewhere is rare.
double Search::log_prior(const Particle& p, const Building& building) const noexcept {
  const double level = domain_.levels != nullptr ? domain_.levels->log_probability(p.room) : 0.0;
  if (domain_.reckoning != nullptr && domain_.reckoning->known()) {
    const double area = domain_.within ? kPi * *domain_.within * *domain_.within : area_;
    return level + domain_.reckoning->log_prior(place(p, RoomFrame(building, p.room)), area);
  }
  if (domain_.near_room == kNoRoom || domain_.within) return level;
  constexpr double kNearSigma = 2.0;
  constexpr double kNearShare = 0.9997;
  const Room& here = building.room(p.room);
  const Room& near = building.room(domain_.near_room);
  double nearness = 0.0;
  if (here.level == near.level) {
    const double d2 = squared_norm(here.frame.transform(p.position) - near.frame.transform(domain_.near_position));
    nearness = area_ / (kTwoPi * kNearSigma * kNearSigma) * fast_exp(-0.5 * d2 / (kNearSigma * kNearSigma));
  }
  return level + fast_log(kNearShare * nearness + 1.0 - kNearShare);
}

void Search::finish(const SearchTools& tools) noexcept {
  phase_ = Phase::done;
  const auto particles = refinement_.population().particles();
  for (Particle& p : particles) p.weight *= fast_exp(log_prior(p, tools.building));
  const double tried = static_cast<double>(std::max<std::size_t>(tried_, 1));
  log_evidence_ = refinement_.log_evidence() + fast_log(refinement_.population().normalize()) - fast_log(tried);
}

void Search::take(Population& out, const SearchTools& tools, Random& random) noexcept {
  phase_ = Phase::idle;
  Population& found = refinement_.population();
  const bool with_twins = looks_all_over();
  const std::size_t most = with_twins ? without_twins(out.capacity()) : out.capacity();
  if (found.size() > most) found.resample(most, random);
  out.clear();
  for (const Particle& p : found.particles()) out.push(p);
  if (with_twins) add_twins(out, tools.scene);
}

}  // namespace echoway::tracker
