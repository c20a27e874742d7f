#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracker/population.hpp"

namespace echoway::test {

/// A belief of so many particles that are sure to be in a row, a metre apart, of weights that grow along it; with
/// memory for `capacity`, or for just these.
inline tracker::Population row_of(std::size_t particles, std::size_t capacity = 0) {
  tracker::Population row(capacity > 0 ? capacity : particles);
  for (std::size_t i = 0; i < particles; ++i) {
    tracker::Particle p;
    p.position.x = static_cast<double>(i);
    p.weight = static_cast<double>(i + 1);
    row.push(p);
  }
  row.normalize();
  return row;
}

/// Where the particles of such a belief are in the mean, metres along the row.
inline double mean_of(std::span<const tracker::Particle> particles) {
  double mean = 0.0, sum = 0.0;
  for (const tracker::Particle& p : particles) {
    mean += p.weight * p.position.x;
    sum += p.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  return mean;
}

/// The same, resampled as two places, of which the farther one has three quarters of the particles.
inline tracker::Population row_in_two_places(std::size_t particles, Random& random) {
  tracker::Population row = row_of(particles);
  std::vector<std::uint8_t> place(particles, 1);
  std::fill_n(place.begin(), particles / 4, std::uint8_t{0});
  row.resample(place, std::array{particles / 4, particles - particles / 4}, random);
  return row;
}

}  // namespace echoway::test
