#include "tracker/likelihood.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracker/association.hpp"
#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kThereAgain = 0.3;             // Chance that what answered once answers again from where it stood,
constexpr double kBesideAxis2 = 0.96 * 0.96;    // if by this squared cosine or less off the axis: 16 degrees;
constexpr double kAlikeAgain = 0.15;            // and that it does so from the same distance.
constexpr double kFrontAgain = 0.55;            // Chance that what stands before a wall answers instead of it again,
constexpr double kFrontSigma = 0.08;            // from as far before it, to so many metres.
constexpr double kLeastFront = 0.1;             // What is less likely to stand there is not noted.

// What may have answered from before a wall, and instead of it.
struct FrontHeard {
  std::uint16_t reflector = 0;
  double depth = 0.0;    // Metres before it.
  double share = 0.0;    // Probability that it did.
};

// What a reading tells about a particle.
struct Hearing {
  Outcome outcome;
  FrontHeard front;        // The likeliest.
  std::size_t count = 0;
  std::array<Association, 2 * ExpectedEchoes::kMax> association;   // The first `count`. The rest is not zeroed.

  [[nodiscard]] std::span<Association> associations() noexcept { return {association.data(), count}; }
  [[nodiscard]] std::span<const Association> associations() const noexcept { return {association.data(), count}; }
};

// Density of the shot's range from what was noted before in no plan.
double remembered(const Particle& p, const Shot& shot, const EchoModel& model) noexcept {
  constexpr double kSpotVariance = 0.12 * 0.12;
  double density = 0.0;
  for (const Spot& spot : shot.spots) {
    if (spot.room != p.room) continue;
    const Vec2 axis = axis_of(p, shot);
    const Vec2 way = spot.at - (p.position + shot.radius * axis);
    const double d = std::sqrt(squared_norm(way));
    if (!(dot(way, axis) > 0.0)) continue;
    const double beam = model.beam(std::abs(cross(axis, way)) / d, true);
    if (beam <= 0.0) continue;
    const double off = shot.range - d * (1.0 + p.log_scale);
    const double variance = kSpotVariance + model.variance(d) + 0.5 * (p.cov.xx + p.cov.yy);
    density += spot.strength * beam * kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * off * off / variance);
  }
  return density;
}

// Density of the shot's range from a stranger that stands where it answered from.
double from_its_place(Vec2 stranger, double sigma, Vec2 axis, const Shot& shot) noexcept {
  const Vec2 way = stranger - shot.radius * axis;
  const double along = dot(way, axis);
  const double d2 = squared_norm(way);
  if (!(along > 0.0 && along * along > kBesideAxis2 * d2)) return 0.0;
  return kThereAgain * gaussian(shot.range - std::sqrt(d2), sigma);
}

// Density of the shot's range from what answered a moment ago and is nothing in the plan, as the particle sees it.
double repeated(const Particle& p, const Shot& shot) noexcept {
  const Vec2 axis = axis_of(p, shot);
  double density = 0.0;
  for (const Repeat& r : shot.repeats) {
    const double chance = p.strangers.chance(r.slot);
    if (!(chance > 0.0)) continue;
    const double there = from_its_place(p.strangers.from_here(r.slot), r.sigma, axis, shot);
    density += chance * (kAlikeAgain * r.alike + there);
  }
  return density;
}

Hearing hear_nothing(const ExpectedEchoes& expected, const Shot& shot, const EchoModel& model) noexcept {
  double survival = 1.0;
  for (int j = 0; j < expected.count; ++j) survival *= 1.0 - expected.echo[static_cast<std::size_t>(j)].chance;
  const double silent = shot.trust * model.silence(survival) + (1.0 - shot.trust) * model.quiet();
  Hearing heard;
  heard.outcome = {silent, silent, 0.0};
  return heard;
}

// Adds a reflector to those that may have answered, unless the range is too far off. Its share is left as the density
// of the range from it, which is returned: what else may have answered is not known yet. `chance`: that it answers, and
// nothing nearer does.
double consider(const ExpectedEcho& e, double chance, const Particle& p, const Shot& shot, const EchoModel& model,
                Hearing& heard) noexcept {
  const double innovation = shot.range - e.range * (1.0 + p.log_scale);
  const double noise = model.variance(e.range) + e.extra_variance;
  const Covariation with = covariation(p.cov, e.gradient(), e.range);
  const double own = std::max(with.x * e.gradient_x + with.y * e.gradient_y + with.k * e.range, 0.0);
  const double variance = noise + own;
  const double normalized = innovation * innovation / variance;
  if (!(normalized < kGate2)) return 0.0;
  const double density = chance * (kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * normalized));
  heard.association[heard.count++] = {density, innovation, own + noise / shot.novelty, with};
  return density;
}

// The same of what is known to stand before a wall.
double consider_front(const ExpectedEcho& wall, double chance, const Fronts::Front& front, const Particle& p,
                      const Shot& shot, const EchoModel& model, Hearing& heard) noexcept {
  ExpectedEcho face = wall;
  face.range -= front.depth;
  face.extra_variance += kFrontSigma * kFrontSigma;
  return consider(face, chance * kFrontAgain * front.chance, p, shot, model, heard);
}

// Density of the shot's range from what stands before a wall, known to or not.
struct Furniture {
  double known = 0.0;
  double other = 0.0;
};

// Takes down which wall it most likely stands before, its share left as a density as those of reflectors are.
Furniture consider_furniture(const ExpectedEcho& wall, double chance, const Particle& p, const Shot& shot,
                             const EchoModel& model, Hearing& heard) noexcept {
  const double depth = wall.range * (1.0 + p.log_scale) - shot.range;
  Furniture before{0.0, chance * model.furniture(depth)};
  const auto front = p.fronts.before(p.room, wall.reflector);
  if (front) before.known = consider_front(wall, chance, *front, p, shot, model, heard);
  const double density = model.quiet() * before.known + before.other;
  if (density > heard.front.share) heard.front = {wall.reflector, depth, density};
  return before;
}

Hearing hear(const Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  const ExpectedEchoes expected = expect(p, shot, model, scene);
  if (!shot.echo) return hear_nothing(expected, shot, model);
  Hearing heard;
  double survival = 1.0;
  double survival_at_range = 1.0;
  double explained = 0.0;
  Furniture furniture;
  for (int j = 0; j < expected.count; ++j) {
    const ExpectedEcho& e = expected.echo[static_cast<std::size_t>(j)];
    const double chance = survival * e.chance;
    explained += consider(e, chance, p, shot, model, heard);
    if (e.of_wall) {
      const Furniture before = consider_furniture(e, chance, p, shot, model, heard);
      furniture.known += before.known;
      furniture.other += before.other;
    }
    survival *= 1.0 - e.chance;
    if (e.range < shot.range) survival_at_range = survival;
  }
  const double again = survival_at_range * (repeated(p, shot) + remembered(p, shot, model));
  const double total = model.echo(explained + furniture.known, survival_at_range, shot.range, furniture.other, again);
  const double density = std::max(kLeastDensity, total);
  const double known = again + model.quiet() * furniture.known;
  const double plan = std::max(kLeastDensity, total - model.heard() * known);

  const double scale = shot.trust * model.heard() * model.quiet() / density;
  for (Association& a : heard.associations()) a.share *= scale;
  heard.front.share *= shot.trust * model.heard() / density;
  const double anything = (1.0 - shot.trust) * model.unexplained(shot.range);
  heard.outcome = {shot.trust * density + anything, shot.trust * plan + anything, scale * explained};
  return heard;
}

void note_stranger(Particle& p, const Shot& shot, const Outcome& outcome) noexcept {
  if (!shot.echo) return;
  const Vec2 from_here = (shot.radius + shot.range) * axis_of(p, shot);
  p.strangers.note(EchoRepeats::slot_of(shot.sensor), from_here, 1.0 - outcome.mapped);
}

void note_front(Particle& p, const FrontHeard& front) noexcept {
  if (front.share > kLeastFront) p.fronts.note(p.room, front.reflector, {front.depth, front.share});
}

}  // namespace

Shot shot_of(const Record& record, const BeltConfig& belt, Vec2 bearing) noexcept {
  Shot shot;
  shot.sensor = record.sensor;
  shot.bearing = bearing;
  shot.bearing_rad = belt.bearing(record.sensor);
  shot.radius = belt.radius_m;
  shot.range = record.range;
  shot.echo = record.echo;
  shot.trust = record.trust;
  shot.novelty = record.novelty;
  return shot;
}

Outcome weigh(const Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  return hear(p, shot, model, scene).outcome;
}

Outcome assimilate(Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  const Hearing heard = hear(p, shot, model, scene);
  merge(p, heard.associations());
  note_stranger(p, shot, heard.outcome);
  note_front(p, heard.front);
  return heard.outcome;
}

Outcome assimilate(Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene,
                   Random& random) noexcept {
  const Hearing heard = hear(p, shot, model, scene);
  merge_or_choose(p, heard.associations(), random);
  note_stranger(p, shot, heard.outcome);
  note_front(p, heard.front);
  return heard.outcome;
}

Outcome hear_in_no_room(Particle& p, const Shot& shot, const EchoModel& model, double density) noexcept {
  const double again = shot.echo ? shot.trust * model.heard() * repeated(p, shot) : 0.0;
  const double plan = std::max(kLeastDensity, density);
  const Outcome outcome{plan + again, plan, 0.0};
  note_stranger(p, shot, outcome);
  return outcome;
}

}  // namespace echoway::tracker
