#pragma once

#include <span>
#include <vector>

#include "echoway/locate/locator.hpp"
#include "thesis/pose_matcher.hpp"

namespace echoway::thesis {

/// A place that has explained the scans since the search began.
struct Place {
  Mode mode{};               ///< Pose of the latest scan; its objective is the mean over `scans`.
  int scans = 0;
};

/// Finds the wearer when the start is not known, which the thesis takes as given: every pose of a grid over all that is
/// left open is matched with the first scan, the best few places are followed through the scans after it, each with the
/// thesis's own bounds, and the search ends when one is left or matches clearly better than the rest.
class BuildingSearch {
 public:
  BuildingSearch(const Start& start, const BeltConfig& belt, const ThesisParameters& parameters);

  /// Takes in a scan. `growth` widens the bounds for time that has passed since the last one.
  void add(const Scan& scan, double growth, std::span<const PoseMatcher> rooms, MatchWorkspace& workspace);

  /// Best first; empty when nothing explains the latest scan.
  [[nodiscard]] const std::vector<Place>& places() const noexcept { return places_; }
  /// Whether the first place stands out.
  [[nodiscard]] bool decided() const noexcept;

 private:
  void begin(const Scan& scan, std::span<const PoseMatcher> rooms, MatchWorkspace& workspace);
  void follow(const Scan& scan, double growth, std::span<const PoseMatcher> rooms, MatchWorkspace& workspace);
  [[nodiscard]] double spacing_for(std::span<const PoseMatcher> rooms, const Bounds& bounds) const noexcept;

  Start start_;
  BeltConfig belt_;
  ThesisParameters parameters_;
  std::vector<Mode> modes_;
  std::vector<Place> places_;
};

}  // namespace echoway::thesis
