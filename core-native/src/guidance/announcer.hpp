#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "echoway/guidance/cue.hpp"
#include "echoway/guidance/guide_config.hpp"

namespace echoway::guidance {

/// How long a line takes to be spoken, from the number of words that its kind has in English.
[[nodiscard]] double spoken_seconds(const Cue& cue, const GuideConfig& config) noexcept;

/// The one voice. A cue that is offered is spoken now or not at all: whoever still means it offers it again. Keeps
/// these promises:
///  1. a line is cut off only by a more urgent one;
///  2. nothing is said twice in GuideConfig::repeat_gap_s, unless asked;
///  3. no line takes another back within GuideConfig::contradiction_gap_s.
class Announcer {
 public:
  explicit Announcer(const GuideConfig& config) : config_(&config) {}

  /// True when `cue` goes out at `now`. `asked`: the wearer wants to hear it (again).
  bool offer(Cue cue, double now, bool asked = false);

  /// The same of what a lost wearer is asked to do to be found, in words that would else lead them.
  bool offer_search(const Cue& cue, double now);

  /// Whether offer() would let it out.
  [[nodiscard]] bool would_speak(const Cue& cue, double now, bool asked = false) const noexcept;

  /// The wearer wants the last instruction again; answer() says it as soon as the voice is free. False: there is none.
  bool ask_again() noexcept {
    again_ = instructed_;
    return instructed_;
  }
  void answer(double now);
  /// Whether they want it now.
  [[nodiscard]] bool is_asked() const noexcept { return again_; }
  /// Whether they want to hear again which way to go: that is told anew, from where they are by now.
  [[nodiscard]] bool is_way_asked() const noexcept;
  /// It is being told, or cannot be: the same words may be said again.
  void take_way_question() noexcept;
  /// The last instruction has been carried out: saying it again would mislead.
  void forget_instruction() noexcept { instructed_ = false; }
  /// The place is known again: what a lost wearer was asked to do is no longer wanted. "Arrived" stays true.
  void forget_search() noexcept;

  /// When the line that is being spoken ends.
  [[nodiscard]] double free_at() const noexcept { return free_at_; }
  [[nodiscard]] bool is_free(double now) const noexcept { return now >= free_at_; }

  /// Takes the oldest cue that has not been fetched.
  bool pop(Cue& cue) noexcept;

 private:
  static constexpr std::size_t kQueue = 32;
  static constexpr std::size_t kMemory = 32;

  [[nodiscard]] std::size_t oldest_that_counts() const noexcept;
  [[nodiscard]] bool repeats(const Cue& cue, double now) const noexcept;
  [[nodiscard]] bool contradicts(const Cue& cue, double now) const noexcept;

  bool say(Cue cue, double now, bool asked, bool searches);

  const GuideConfig* config_;
  double free_at_ = -1e300;
  Urgency speaking_ = Urgency::colour;
  std::array<Cue, kMemory> said_{};
  std::size_t said_count_ = 0;
  Cue instruction_{};               ///< The last line that told the wearer to do something.
  bool instructed_ = false;
  bool searching_ = false;          ///< It is one by which a lost wearer is found.
  std::optional<Cue> arrival_;      ///< The instruction before the search that began last, when it was "arrived".
  bool again_ = false;
  std::size_t waived_ = 0;          ///< What was said before this many lines may be said again.
  std::array<Cue, kQueue> queue_{};
  std::size_t head_ = 0;
  std::size_t size_ = 0;
};

}  // namespace echoway::guidance
