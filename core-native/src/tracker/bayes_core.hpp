#pragma once

#include <array>
#include <optional>
#include <span>

#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/dead_reckoning.hpp"
#include "tracker/echo_memory.hpp"
#include "tracker/echo_pairs.hpp"
#include "tracker/echo_repeats.hpp"
#include "tracker/fit_monitor.hpp"
#include "tracker/history.hpp"
#include "tracker/level_belief.hpp"
#include "tracker/level_links.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/modes.hpp"
#include "tracker/motion.hpp"
#include "tracker/novelty.hpp"
#include "tracker/population.hpp"
#include "tracker/range_rate.hpp"
#include "tracker/rivals.hpp"
#include "tracker/search.hpp"
#include "tracker/sensor_health.hpp"
#include "tracker/summary.hpp"
#include "tracker/understudy.hpp"

namespace echoway {

/// The tracker's parts and how they play together. Starting is in bayes_start.cpp, a firing's way in bayes_core.cpp,
/// what is learnt of the wearer's movement in bayes_motion.cpp, how far the belt hears in bayes_hearing.cpp, the second
/// belief in bayes_understudy.cpp, searching and recovering in bayes_recovery.cpp, doubting a place in bayes_doubt.cpp.
class BayesLocator::Core {
 public:
  Core(const Building& building, const BeltConfig& belt, const Start& start, const BayesOptions& options);

  bool on_firing(const Firing& firing);
  void on_motion(const MotionHint& hint);
  void on_temperature(double celsius);
  void on_level_transition(const LevelTransition& transition) { links_.expect(transition); }
  void on_led(bool led) noexcept { links_.lead(led); }
  void on_doubt() noexcept { doubt_ = Doubt::due; }

  [[nodiscard]] const Estimate& estimate() const noexcept { return estimate_; }
  [[nodiscard]] const tracker::Summary& summary() const noexcept { return summary_; }
  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const noexcept { return health_.suspicions(); }

 private:
  static constexpr double kUsuallyMapped = 0.7;      ///< mapped_share_ of a belief that is new.
  static constexpr double kLeastScaleSigma = 0.004;  ///< The speed of sound is never known better.
  static constexpr int kConfirmed = 160;             ///< Firings: ten seconds.
  static constexpr double kSure = 0.9;               ///< Probability of the place from which on it is tracked.
  static constexpr int kFewestEchoes = 2;            ///< Less is not worth a search.
  static constexpr double kPerhapsAway = 0.2;        ///< away_ from which on nobody is looked for in the rooms,
  static constexpr double kSurelyAway = 0.5;         ///< and from which on they are taken to be on the stairs.

  // Starting.
  void begin();
  void place_known(const Pose2& pose, RoomIndex room, bool heading_known);
  void describe_ignorance();

  // A firing.
  [[nodiscard]] bool tell_time(double time_s, double& seconds);
  [[nodiscard]] tracker::Record take_down(const Firing& firing, double seconds);
  /// What tells of the wearer's gait besides the place.
  struct Evidence {
    tracker::HintIntegrator::GaitEvidence gait;   ///< By the steps.
    std::optional<double> still;                  ///< For standing, by an echo and the last one (stillness()),
    std::optional<tracker::SpeedReading> speed;   ///< and how fast the wearer walks, if they do.
  };
  [[nodiscard]] Evidence take_evidence(const tracker::Record& record, double time_s);
  [[nodiscard]] tracker::Shot aim(const tracker::Record& record) const;
  /// What a population made of a reading.
  struct Verdict {
    double log_plan = 0.0;    ///< Log density of the reading by the plan alone.
    double mapped = 0.0;      ///< Probability that something in the plan answered.
  };
  Verdict update(tracker::Population& population, const tracker::Record& record, const Evidence& evidence,
                 const tracker::Shot& shot);
  /// Whether what the sensor says shows how well a place fits: a suspect one's readings fit none.
  [[nodiscard]] static bool shows_fit(const tracker::Record& record) noexcept { return record.trust > 0.5; }
  /// Lets the monitor of a belief see what that made of a reading, unless the sensor is suspect.
  void show(tracker::FitMonitor& fit, const Verdict& verdict, const tracker::Record& record) const noexcept;
  void heed_pair(tracker::Population& population, const Evidence& evidence, double unexplained) const;
  [[nodiscard]] double mapped_share_of(const tracker::Particle& p, tracker::Shot shot);
  [[nodiscard]] tracker::Outcome hear_away(tracker::Particle& p, const tracker::Shot& shot, double anywhere) const;
  void track(tracker::Record& record, const Evidence& evidence);
  /// The belief, its understudy and its rivals, as far as there are any.
  template <typename Action>
  void for_all_beliefs(const Action& action) {
    if (!main_.empty()) action(main_);
    if (understudy_.present()) action(understudy_.population());
    for (tracker::Rival& rival : rivals_) {
      if (rival.present()) action(rival.population());
    }
  }
  void thin_out(tracker::Population& population);
  void resample(tracker::Population& population, std::size_t target);
  [[nodiscard]] int echoes_since(std::uint64_t firing) const;
  [[nodiscard]] std::span<const tracker::Spot> recall(const tracker::Shot& shot);
  void remember(const tracker::Record& record);
  void conclude(double time_s);
  void see_who_is_away();
  [[nodiscard]] bool perhaps_away() const noexcept { return away_ > kPerhapsAway; }
  [[nodiscard]] bool covered() const noexcept { return near_in_a_row_ >= 2 * belt_.sensors; }
  [[nodiscard]] TrackState state() const;

  // The wearer's movement.
  void follow_movement(const tracker::Interval& interval);
  void reckon_on(const tracker::Interval& interval);
  void reckon_from_here();
  void learn_pace(double time_s);
  void learn_step_length(double metres);
  void stand_still(double rate);

  // How far the belt hears.
  void choose_model(const tracker::Record& record);
  [[nodiscard]] int echoes_beyond(double range) const;
  [[nodiscard]] bool hears_far() const;
  [[nodiscard]] bool seems_hard_of_hearing(RoomIndex only_room) const;
  void conclude_first_search();
  void conclude_hearing_test();

  // Searching and recovering.
  void pursue_search();
  void start_first_search();
  void start_recovery();
  [[nodiscard]] bool may_be_elsewhere() const;
  void look_where_stairs_lead(tracker::SearchDomain& domain, std::uint64_t begin) const;
  void look_in_a_circle(tracker::SearchDomain& domain, std::uint64_t begin) const;
  [[nodiscard]] Pose2 likely_pose() const;
  [[nodiscard]] double turned_back(double heading, std::uint64_t firing) const;
  [[nodiscard]] std::optional<double> compass_at(std::uint64_t firing) const;
  [[nodiscard]] double log_belief(std::uint64_t begin, std::uint64_t first, double log = 0.0) const;
  void challenge();
  void start_doubting();
  void land_all();
  void conclude_doubt();
  [[nodiscard]] std::optional<LevelTransition> link_to_take() const;
  [[nodiscard]] bool is_doubted(const tracker::Particle& p) const;
  void follow_understudy(tracker::Record& record, const Evidence& evidence, const tracker::Shot& shot);
  void begin_understudy();
  void believe_understudy();
  void dismiss_others() noexcept;
  void forget_surroundings();
  [[nodiscard]] tracker::Rival::Belief state_of_belief() const;
  void judge_rivals(const tracker::Record& record, const Evidence& evidence, const tracker::Shot& shot);
  [[nodiscard]] bool may_search() const;
  [[nodiscard]] bool is_search_needless() const;
  void believe(tracker::Rival& rival);
  [[nodiscard]] std::uint64_t search_pause() const;
  [[nodiscard]] double handicap() const;
  [[nodiscard]] tracker::SearchTools tools() const;

  const Building& building_;
  BeltConfig belt_;
  Start start_;
  BayesOptions options_;
  tracker::EchoModel keen_;                    ///< Tells places apart: for who is looked for,
  tracker::EchoModel wary_;                    ///< and this for who is followed, once the place has proved itself.
  tracker::EchoModel deafened_;                ///< Of a belt that hears only what is near.
  const tracker::EchoModel* model_ = &keen_;   ///< Whichever serves at the moment.
  enum class HearingTest { due, running, done } hearing_test_ = HearingTest::due;
  const tracker::EchoModel* other_model_ = &deafened_;   ///< With which the first search is made again.
  double log_first_ = 0.0;                     ///< Log evidence, with the prior odds, of what the first model found
  std::uint64_t first_until_ = 0;              ///< by the firings before this one.
  enum class Doubt { none, due, running } doubt_ = Doubt::none;   ///< Raised by who leads the wearer.
  std::optional<LevelTransition> doubted_link_;                   ///< The wearer finds none where they were to take it.
  mutable scene::Scene scene_;
  tracker::MotionParameters motion_;
  Random random_;
  tracker::Population main_;
  tracker::Modes modes_;
  tracker::Rivals rivals_;
  tracker::Understudy understudy_;
  tracker::Search search_;
  tracker::SensorHealth health_;
  tracker::History history_;
  tracker::HintIntegrator hints_;
  tracker::FitMonitor fit_;
  tracker::LevelLinks links_;
  tracker::LevelBelief levels_;
  tracker::DeadReckoning reckoning_;
  tracker::EchoMemory memory_;
  tracker::EchoRepeats repeats_;
  tracker::Novelty novelty_;
  tracker::EchoPairs pairs_;
  double away_ = 0.0;               ///< Probability that the wearer is on stairs or in an elevator,
  tracker::LevelLinks::Landing landing_;   ///< and where that leads, most likely.
  double mapped_share_ = 0.0;       ///< Of recent echoes that something in the plan explains.
  double unmapped_ = 0.0;           ///< Probability that the last echo came from nothing in the plan.
  std::array<Vec2, kMaxSensors> bearings_{};
  std::optional<double> compass_;   ///< What it said last before a place was found for sure, in the levels' frames,
  std::uint64_t compass_said_ = 0;  ///< and before which firing.

  bool clock_set_ = false;
  double last_time_ = 0.0;
  int backwards_ = 0;
  int near_in_a_row_ = 0;           ///< Firings in a row that heard something within arm's reach.
  bool gyro_ = false;
  int blind_for_ = 0;               ///< Firings in a row before which no gyroscope told how far the wearer turned.
  double pace_ = 0.55;              ///< Usual walking speed, learnt.
  double step_length_ = 0.65;       ///< Metres of a usual step, learnt.
  double step_firings_ = 0.0;       ///< Firings that it was learnt from, kMostFirings at most.
  double log_scale_ = 0.0;
  double log_scale_sigma_ = 0.0;
  int fruitless_ = 0;               ///< Searches since a place was taken for granted, each wider than the one before.
  int poor_for_ = 0;                ///< Firings in a row for which the belief has fitted badly.
  int explained_ = 0;               ///< Firings in a row that a place taken for granted has explained well.
  int unconfirmed_ = 0;             ///< Firings that a place which was found must yet explain to be taken for granted.
  std::uint64_t searches_ = 0;      ///< Recovery searches so far.
  std::uint64_t last_search_ = 0;   ///< End of the history when it ended; 0: none yet.

  Estimate estimate_;
  tracker::Summary summary_;
};

}  // namespace echoway
