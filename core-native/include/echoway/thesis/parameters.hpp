#pragma once

#include "echoway/acoustics/detection.hpp"
#include "echoway/acoustics/range_model.hpp"
#include "echoway/units.hpp"

namespace echoway {

/// Every constant of the thesis's method, with the section that gives it; "chosen" where the thesis is silent.
/// docs/thesis-method.md says why.
struct ThesisParameters {
  // Scan processing (section 5.1).
  int passes = 2;                            ///< Passes averaged into a scan.
  double missing_range_factor = 2.0;         ///< A missing echo reads as this times the maximum range (section 4.1).
  double outlier_deviations = 2.0;           ///< Readings beyond mean + this many standard deviations are dropped.

  // Postulated poses (section 5.1).
  double movement_m = feet(5.0);             ///< Radius of the circle about the last position.
  double rotation_rad = degrees(20.0);       ///< To either side of the last heading.
  double position_spacing_m = feet(0.5);     ///< Of the grid of positions; chosen.
  double heading_spacing_rad = degrees(4.0); ///< Of the grid of headings, rounded to a whole share of the sensors'
                                             ///< spacing; chosen.
  int refinements = 3;                       ///< Times that the grid is halved around its best pose; chosen.
  double widest_growth = 4.0;                ///< The bounds grow with the time since the last good match, at most so
                                             ///< many times; chosen.
  double poor_match_m = 0.2;                 ///< An objective above this is not a good match; chosen.

  // Objective (5.1).
  double wall_weight = 2.0;                  ///< w1; at least twice w2 (section 6.2.3).
  double corner_weight = 1.0;                ///< w2, of corners and edges.
  double reflector_weight = 2.0;             ///< Of all-reflective elements, which reflect once like walls; chosen.
  int least_matches = 4;                     ///< A pose with fewer readings to compare is discarded (section 5.1).

  // Beyond (5.1), which minimises over whatever four readings a pose can make fit; as_printed() is without.
  double mismatch_m = 0.4;                   ///< The most that one difference counts; chosen.
  double unexplained_m = 0.3;                ///< What a reading counts that the simulation has none for; chosen.
  double unheard_m = 0.15;                   ///< What a simulated reading counts that no echo came for; chosen.
  double displacement_m = 0.2;               ///< What moving as far as the bounds allow counts, less in proportion to
                                             ///< the square of the distance; chosen.

  // Room occupancy (section 5.2).
  double exit_reach_m = feet(4.0);           ///< Adjoining rooms become candidates this near to an exit.
  double candidate_growth = 2.0;             ///< Candidates' bounds are this much wider.
  double enter_likelihood = 0.8;             ///< Above it a candidate becomes the current room.
  bool compare_by_range = true;              ///< Rooms are compared by the objective over their range (section 6.2.1),
                                             ///< else by the objective itself; chosen.
  double purge_likelihood = 0.1;             ///< Below it a candidate leaves the queue.

  // Search with an unknown start: the thesis has none (it "starts with the approximate initial user pose").
  double search_spacing_m = feet(1.0);       ///< Of the grid over a whole room.
  double search_heading_spacing_rad = degrees(6.0);
  int search_candidates = 1'500'000;         ///< The grid is coarsened so that the building needs no more poses.
  int hypotheses = 12;                       ///< Places kept while several explain the echoes.
  double unique_margin_m = 0.12;             ///< A place stands out when the next best is worse by this much, over the
                                             ///< number of scans compared.

  // What is reported.
  int lost_after = 3;                        ///< Scans in a row without a good match until the wearer is lost; chosen.
  double map_error_m = 0.05;                 ///< By how far walls are off the plan, standard deviation; chosen.

  DetectionParameters detection{};
  RangeModelParameters model{};

  /// Objective (5.1) to the letter: readings without a counterpart are left out, and differences count in full.
  [[nodiscard]] static ThesisParameters as_printed() {
    ThesisParameters p;
    p.mismatch_m = 1e9;
    p.unexplained_m = p.unheard_m = p.displacement_m = 0.0;
    p.poor_match_m = 1e9;
    return p;
  }
};

}  // namespace echoway
