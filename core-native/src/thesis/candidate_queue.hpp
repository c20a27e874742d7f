#pragma once

#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/thesis/parameters.hpp"
#include "thesis/pose_matcher.hpp"

namespace echoway::thesis {

/// A room next door that the wearer may have entered.
struct Candidate {
  RoomIndex room = kNoRoom;
  double likelihood = 0.0;
  Match match{};            ///< Of the latest scan.
};

/// P(NR) after one more match of the current and of the candidate room (thesis (5.2)-(5.4)); the matches are normalised
/// objectives, the less the better. Within [0, 1] when `likelihood` is and both matches are >= 0.
[[nodiscard]] double updated_likelihood(double likelihood, double match_current, double match_candidate) noexcept;

/// The queue of candidate rooms (thesis section 5.2).
class CandidateQueue {
 public:
  CandidateQueue(const ThesisParameters& parameters, std::size_t rooms);

  /// Appends `room`, likelihood 0, unless it is there already.
  void add(RoomIndex room);
  [[nodiscard]] std::vector<Candidate>& candidates() noexcept { return queue_; }
  [[nodiscard]] const std::vector<Candidate>& candidates() const noexcept { return queue_; }

  /// Brings every likelihood up to date with the matches of the latest scan, `current` being the current room's.
  void update(const Match& current);
  /// The likeliest candidate that has passed the upper threshold; nullptr when none has.
  [[nodiscard]] const Candidate* entered() const noexcept;
  /// Drops candidates below the lower threshold; those behind move up.
  void purge();
  void flush() noexcept { queue_.clear(); }

 private:
  ThesisParameters parameters_;
  std::vector<Candidate> queue_;
};

}  // namespace echoway::thesis
