#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tracker/elementary.hpp"
#include "tracker/history.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/panorama.hpp"
#include "tracker/population.hpp"
#include "tracker/refinement.hpp"
#include "tracker/search_domain.hpp"
#include "tracker/search_grid.hpp"

namespace echoway::tracker {

/// Looks for the wearer over a whole building. First a sweep: a grid of positions and headings is replayed through a
/// window of recent firings, each candidate a coarse particle that stands for its cell, dropped as soon as it falls
/// hopelessly behind the best, or behind the belief that it is to beat. Then a refinement: particles drawn from the
/// survivors' cells are replayed up to the present with the beam as sharp as it is, and weighted by importance (Doucet
/// et al. 2000, section 2). The work is cut into slices, so that one firing never costs more than its budget.
class Search {
 public:
  struct Parameters {
    double spacing = 0.36;               ///< Metres between positions; less where there is little floor to search, ...
    double closest_spacing = 0.18;       ///< ... down to this, as long as there are no more candidates than ...
    double few_candidates = 60000;       ///< ... so many.
    double heading_step = degrees(12.0);  ///< Half the angle between sensors, as a panorama's directions.
    double give_up = 8.0;                ///< Log likelihood behind the best at the same firing.
    std::size_t keep = 4000;             ///< Survivors of the sweep.
    std::size_t refined = 1500;          ///< Particles drawn from them, ...
    std::size_t refined_thoroughly = 2400;   ///< more where none of like places may be missed, ...
    std::size_t refined_facing = 800;    ///< ... fewer when it is known where the wearer faces,
    std::size_t refined_locally = 600;   ///< and of a search that only looks about a place.
    std::size_t budget = 56000;          ///< Readings looked up in a panorama per slice ...
    std::size_t second_budget = 44000;   ///< The same while some place is believed in already,
    std::size_t local_budget = 20000;    ///< and of a search that only looks about it.
    std::size_t look_cost = 8;           ///< ... of which a direction that must first be worked out costs so many,
    std::size_t replay_cost = 6;         ///< a firing that is replayed exactly
    std::size_t compile_cost = 4;        ///< and an occluder listed for a cell that must first be compiled.
    std::size_t most_candidates = 1500000;
    double usual_area = 1000.0;          ///< Square metres. A larger building is searched in slices that grow with it,
    double largest_slice = 4.0;          ///< to so many times the usual ones: nobody shall wait a minute.
  };

  Search(const scene::Scene& scene, const Parameters& parameters);

  /// Starts over the firings [`begin`, `end`) of the history, one at least. No allocation.
  void start(SearchDomain domain, std::uint64_t begin, std::uint64_t end) noexcept;
  void stop() noexcept { phase_ = Phase::idle; }
  [[nodiscard]] bool running() const noexcept { return phase_ == Phase::sweeping || phase_ == Phase::refining; }

  /// Works for one slice. Returns true when it is over: what was found stands at the present and may be taken, or the
  /// sweep found nothing that beats the belief, and log_evidence() is lower than any likelihood.
  bool work(const SearchTools& tools, Random& random) noexcept;

  /// Puts what was found into `out`, at most its capacity; with the twins of every place (twins.hpp) when it was looked
  /// for all round, in a room or everywhere. REQUIRES: the search is over and has found something.
  void take(Population& out, const SearchTools& tools, Random& random) noexcept;
  [[nodiscard]] const SearchDomain& domain() const noexcept { return domain_; }
  /// Of the building's rooms, square metres.
  [[nodiscard]] double area() const noexcept { return area_; }
  /// Firings that tell the domain's places apart when nothing is known of them: a pass of `sensors`; of all of a large
  /// building, more.
  [[nodiscard]] std::uint64_t firings_to_tell(const SearchDomain& domain, int sensors) const noexcept;
  [[nodiscard]] bool is_local() const noexcept { return domain_.within.has_value(); }
  /// Log of the mean likelihood of the window's firings (up to the present) over the whole domain.
  [[nodiscard]] double log_evidence() const noexcept { return log_evidence_; }
  [[nodiscard]] std::uint64_t window_begin() const noexcept { return begin_; }

 private:
  enum class Phase { idle, sweeping, refining, done };
  struct Survivor {
    RoomIndex room = kNoRoom;
    Vec2 position{};                     ///< Of its cell's centre at the window's begin.
    double heading = 0.0;
    double log_likelihood = 0.0;
    std::uint64_t lot = 0;               ///< Decides between equals, of which a long hall has many: each has its own.
  };
  [[nodiscard]] bool heading_is_known() const noexcept {
    return domain_.heading || domain_.near_heading || domain_.level_heading;
  }
  /// Whose heading is known, or about where they are, is not taken for somebody at the room's other end; nor are the
  /// places beyond stairs, of which most are alike, kept in mind for long.
  [[nodiscard]] bool looks_all_over() const noexcept { return !is_local() && !heading_is_known(); }
  /// Whether it is all of a large building.
  [[nodiscard]] bool is_large(const SearchDomain& domain) const noexcept {
    return slice_ > 1.0 && domain.only_room == kNoRoom && !domain.within;
  }
  [[nodiscard]] bool next_candidate(const SearchTools& tools, double& heading) noexcept;
  [[nodiscard]] std::optional<double> heading_in_room(const Building& building) const noexcept;
  [[nodiscard]] Particle candidate(const SearchTools& tools, RoomIndex room, Vec2 position, double heading,
                                   double sigma) const noexcept;
  [[nodiscard]] Record from_begin(const History& history, std::uint64_t number) const noexcept;
  /// One firing as the sweep sees it.
  struct Leg {
    Vec2 way{};                          ///< From the window's begin, in the heading's frame then, at 1 m/s.
    double bearing = 0.0;                ///< Of the sensor, from the heading at the window's begin.
    double seconds = 0.0;
    double range = 0.0;
    double novelty = 1.0;
    bool echo = false;
    double log_belief = 0.0;             ///< What the belief made of it.
  };
  /// Firings from the window's begin on that the sweep goes through.
  [[nodiscard]] std::uint64_t window() const noexcept {
    return std::min<std::uint64_t>(end_ - begin_, kMostSwept);
  }
  void reckon(const SearchTools& tools) noexcept;
  void put_echoes_first() noexcept;
  void enter_belief() noexcept;
  [[nodiscard]] bool beats_belief() const noexcept;
  [[nodiscard]] double likelihood(const SearchTools& tools, const Leg& leg, const SinCos& facing, double heading,
                                  const scene::Cell& seen) noexcept;
  [[nodiscard]] std::size_t try_candidate(const SearchTools& tools, double heading) noexcept;
  void keep(const Survivor& survivor) noexcept;
  void in_order_of_place() noexcept;
  void draw_from_survivors(const SearchTools& tools, Random& random) noexcept;
  [[nodiscard]] std::size_t to_draw() const noexcept {
    if (is_local()) return parameters_.refined_locally;
    if (heading_is_known()) return parameters_.refined_facing;
    return domain_.thorough || is_large(domain_) ? parameters_.refined_thoroughly : parameters_.refined;
  }
  [[nodiscard]] double heading_cell() const noexcept {
    return heading_is_known() ? domain_.heading_sigma : parameters_.heading_step;
  }
  void finish(const SearchTools& tools) noexcept;
  [[nodiscard]] double log_prior(const Particle& particle, const Building& building) const noexcept;

  [[nodiscard]] std::size_t budget() const noexcept;

  Parameters parameters_;
  double hopeless_;                      ///< Likelihood over that of the best from which on it is given up.
  double slice_ = 1.0;                   ///< Of a search of everywhere, as a multiple of the usual one.
  double area_;                          ///< Of the building's rooms, square metres.
  Phase phase_ = Phase::idle;
  SearchDomain domain_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;

  SearchGrid grid_;
  int turn_ = 0, turns_ = 0;             ///< Of the next heading at its place, and how many there are.
  std::optional<double> centre_;         ///< Heading about which to look, in the frame of the place's room.

  static constexpr std::size_t kMostSwept = 24;   ///< A double holds the product of so many least densities.
  std::array<Leg, kMostSwept> legs_{};
  std::size_t swept_ = 0;
  std::array<double, kMostSwept> best_{};   ///< Likelihood of the best candidate up to each leg.
  double log_belief_ = 0.0;              ///< The belief's, of all legs.
  Panorama panorama_;
  std::size_t tried_ = 0;
  std::vector<Survivor> survivors_;      ///< A heap, the least likely on top, while sweeping.
  std::size_t count_ = 0;
  Refinement refinement_;
  double log_evidence_ = 0.0;
};

}  // namespace echoway::tracker
