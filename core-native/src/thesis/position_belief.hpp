#pragma once

#include "echoway/geometry/pose2.hpp"
#include "echoway/thesis/parameters.hpp"
#include "thesis/pose_matcher.hpp"

namespace echoway::thesis {

/// A symmetric 2 x 2 matrix.
struct Symmetric2 {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  friend constexpr Symmetric2 operator+(Symmetric2 a, Symmetric2 b) noexcept {
    return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
  }
  [[nodiscard]] double greatest_eigenvalue() const noexcept;
  /// REQUIRES: positive definite.
  [[nodiscard]] Symmetric2 inverse() const noexcept;
  /// Seen from a frame turned by `angle`.
  [[nodiscard]] Symmetric2 rotated(double angle) const noexcept;
};

/// How well the position is known. The thesis reports none; this is what its matches support: each scan adds the
/// information of the readings that it matched, each scan's movement takes some away. Where no reading says anything
/// about a direction, along a plain hall, the uncertainty grows from scan to scan.
class PositionBelief {
 public:
  /// Knows the position to within `sigma`, metres.
  void reset(double sigma) noexcept { covariance_ = {sigma * sigma, 0.0, sigma * sigma}; }
  /// The wearer may have moved by `sigma`, metres, in any direction (at least a centimetre).
  void move(double sigma) noexcept;
  /// Takes in what the matched readings say.
  void observe(const Scan& scan, const Match& match, const RangeModel& model,
               const ThesisParameters& parameters) noexcept;
  void rotate(double angle) noexcept { covariance_ = covariance_.rotated(angle); }

  [[nodiscard]] const Symmetric2& covariance() const noexcept { return covariance_; }

 private:
  Symmetric2 covariance_{};
};

}  // namespace echoway::thesis
