#include "thesis/candidate_queue.hpp"

#include <algorithm>

namespace echoway::thesis {
namespace {

// What a room that no pose matches in is worth: a normalised match of 1 is off by the room's whole range.
constexpr double kNoMatch = 1.0;
constexpr double kNoMatchM = feet(35.0);  // The same where objectives are compared as they are: the sensors' range.

// What stands for match_CR and match_NR.
double worth(const Match& match, const ThesisParameters& parameters) noexcept {
  if (!match.found) return parameters.compare_by_range ? kNoMatch : kNoMatchM;
  return parameters.compare_by_range ? std::min(match.quality, kNoMatch) : std::min(match.objective_m, kNoMatchM);
}

}  // namespace

double updated_likelihood(double likelihood, double match_current, double match_candidate) noexcept {
  const double sum = match_current + match_candidate;
  const double fresh = sum > 0.0 ? match_current / sum : 0.5;
  if (match_current < match_candidate) return 0.5 * (likelihood + fresh);  // (5.2)
  return likelihood + fresh - fresh * likelihood;                          // (5.3), (5.4)
}

CandidateQueue::CandidateQueue(const ThesisParameters& parameters, std::size_t rooms) : parameters_(parameters) {
  queue_.reserve(rooms);
}

void CandidateQueue::add(RoomIndex room) {
  if (std::any_of(queue_.begin(), queue_.end(), [&](const Candidate& c) { return c.room == room; })) return;
  queue_.push_back({room, 0.0, {}});
}

void CandidateQueue::update(const Match& current) {
  for (Candidate& candidate : queue_) {
    candidate.likelihood =
        updated_likelihood(candidate.likelihood, worth(current, parameters_), worth(candidate.match, parameters_));
  }
}

const Candidate* CandidateQueue::entered() const noexcept {
  const auto likeliest = std::max_element(queue_.begin(), queue_.end(), [](const Candidate& a, const Candidate& b) {
    return a.likelihood < b.likelihood;
  });
  if (likeliest == queue_.end() || !(likeliest->likelihood > parameters_.enter_likelihood)) return nullptr;
  return likeliest->match.found ? &*likeliest : nullptr;
}

void CandidateQueue::purge() {
  std::erase_if(queue_, [&](const Candidate& c) { return c.likelihood < parameters_.purge_likelihood; });
}

}  // namespace echoway::thesis
