#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "echoway/units.hpp"

namespace echoway {

/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], by Newton's method on the Legendre recurrence.
template <std::size_t N>
struct GaussLegendre {
  std::array<double, N> node{};
  std::array<double, N> weight{};

  GaussLegendre() noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      double x = std::cos(kPi * (static_cast<double>(i) + 0.75) / (static_cast<double>(N) + 0.5));
      double slope = 1.0;
      for (int iteration = 0; iteration < 8; ++iteration) {
        double previous = 1.0;
        double value = x;
        for (std::size_t k = 2; k <= N; ++k) {
          const double n = static_cast<double>(k);
          const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * previous) / n;
          previous = value;
          value = next;
        }
        slope = static_cast<double>(N) * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
      }
      node[i] = x;
      weight[i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

}  // namespace echoway
