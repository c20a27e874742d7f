#pragma once

#include <array>
#include <cstddef>

#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

/// What a wearer has asked for and is told as soon as the voice and the place allow: where they are, and the way that a
/// destination just set will take.
class Answers {
 public:
  /// REQUIRES: `router` outlives this.
  explicit Answers(const Router& router) : router_(&router) {}

  void ask_where() noexcept { where_ = true; }
  [[nodiscard]] bool is_where_asked() const noexcept { return where_; }
  /// A line has said that the place is not known.
  void where_was_answered() noexcept { where_ = false; }
  void ask_destination() noexcept { destination_ = true; }
  /// What was told of the place no longer holds: a half given answer is given afresh.
  /// `leading`: there is a destination.
  void start_over(bool leading) noexcept;

  /// Offers the next line of an answer. `route`: null without a destination.
  void tell(const Estimate& estimate, const Route* route, Announcer& voice);
  /// Whether lines of "where am I" are still to come.
  [[nodiscard]] bool is_answering() const noexcept { return next_ < count_; }

 private:
  void tell_destination(const Estimate& estimate, const Route* route, Announcer& voice);
  void gather_where(const Estimate& estimate);

  const Router* router_;
  bool where_ = false;
  bool destination_ = false;
  std::array<Cue, 3> lines_{};  ///< First to last.
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  double asked_at_ = 0.0;
};

}  // namespace echoway::guidance
