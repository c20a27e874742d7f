#include "tracker/modes.hpp"

#include <gtest/gtest.h>

#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

constexpr Vec2 kHere{1.0, 1.0};
constexpr Vec2 kThere{7.0, 1.0};
constexpr std::size_t kParticles = 100;

/// `share` of the weight at kThere, turned round; the rest at kHere.
Population belief_in_two_places(double share) {
  Population population(400);
  for (std::size_t i = 0; i < kParticles; ++i) {
    Particle p;
    const bool there = i % 2 == 0;
    p.room = 0;
    p.position = there ? kThere : kHere;
    p.heading = there ? kPi : 0.0;
    p.weight = (there ? share : 1.0 - share) / (0.5 * kParticles);
    population.push(p);
  }
  return population;
}

double weight_at(const Population& population, Vec2 place) {
  double weight = 0.0;
  for (const Particle& p : population.particles()) weight += distance(p.position, place) < 0.1 ? p.weight : 0.0;
  return weight;
}

class ModesTest : public ::testing::Test {
 protected:
  void resample(Population& population, int times = 1) {
    for (int i = 0; i < times; ++i) {
      const Summary summary = summarize(population.particles(), building_, SummaryParameters{});
      modes_.resample(population, summary, building_, kParticles, false, random_);
    }
  }

  Building building_ = test::plain_hall();
  Modes modes_{400, Modes::Parameters{}};
  Random random_{1};
};

TEST_F(ModesTest, AnUnlikelyPlaceOutlivesAnyNumberOfResamplings) {
  Population population = belief_in_two_places(0.001);
  resample(population, 1000);
  EXPECT_NEAR(weight_at(population, kThere), 0.001, 1e-9);
  EXPECT_NEAR(weight_at(population, kHere), 0.999, 1e-9);
  Population plainly = belief_in_two_places(0.001);
  for (int i = 0; i < 1000; ++i) plainly.resample(kParticles, random_);
  EXPECT_EQ(weight_at(plainly, kThere), 0.0);
}

TEST_F(ModesTest, APlaceThatIsNoLongerPossibleCostsNothingMore) {
  Population population = belief_in_two_places(1e-7);
  resample(population);
  EXPECT_EQ(weight_at(population, kThere), 0.0);
  EXPECT_EQ(population.size(), kParticles);
}

TEST_F(ModesTest, ALikelyPlaceHasParticlesByItsProbability) {
  Population population = belief_in_two_places(0.4);
  resample(population);
  EXPECT_EQ(population.size(), kParticles);
  EXPECT_EQ(population.main_size(), 60u);
}

TEST_F(ModesTest, EvidenceBetweenPlacesWeighsLessThanWithinThem) {
  Population population = belief_in_two_places(0.5);
  resample(population);
  population.weigh_modes();
  const Vec2 first = population.particles()[0].position;
  for (Particle& p : population.particles()) p.weight *= distance(p.position, first) < 0.1 ? 1.0 : 1e-4;
  population.particles()[0].weight *= 0.5;
  const double within = population.particles()[0].weight / population.particles()[1].weight;
  population.temper_modes(0.25);
  population.normalize();
  const Vec2 other = distance(first, kHere) < 0.1 ? kThere : kHere;
  EXPECT_NEAR(weight_at(population, other) / weight_at(population, first), 0.1, 0.005);
  EXPECT_DOUBLE_EQ(population.particles()[0].weight / population.particles()[1].weight, within);
}

}  // namespace
}  // namespace echoway::tracker
