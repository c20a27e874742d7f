#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "echoway/belt/belt.hpp"
#include "echoway/belt/belt_health.hpp"
#include "echoway/building/building.hpp"
#include "echoway/guidance/cue.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/motion/motion_hint.hpp"
#include "echoway/result.hpp"
#include "echoway/routing/route.hpp"
#include "echoway/scene/echo_explainer.hpp"
#include "echoway/scene/scene_report.hpp"

namespace echoway {

enum class Method : std::uint8_t {
  bayes,   ///< The tracker: an estimate at every firing (docs/tracker.md).
  thesis,  ///< The thesis's method: an estimate every two passes (docs/thesis-method.md).
};

struct SessionConfig {
  BeltConfig belt{};
  Method method = Method::bayes;
  Start start{};
  std::uint64_t seed = 1;
  std::optional<double> air_c{};  ///< Temperature of the air, Celsius, until the belt's thermometer says another.
};

/// Everything the core does for one wearer in one building, behind one door: JNI, the command line and the tests all
/// come in here.
///
/// Input goes in by on_bytes() or on_firing(), on_motion() and on_tick(), in any mixture, from one thread, with times
/// in seconds on one monotonic clock. Output is read between calls; references stay valid until the next input.
///
/// Guarantees: nothing throws; no input makes it crash, hang or emit a NaN; nothing is allocated after open() except by
/// restart(), by the first explain_scan() and when a destination is set; the same calls give the same output, bit for
/// bit.
class Session {
 public:
  /// Fails when the building is unusable or the configuration makes no sense (sensor count outside 1 ... kMaxSensors,
  /// negative radius, a start where nobody can stand (see check_start()), air below absolute zero, anything not
  /// finite).
  static Result<std::unique_ptr<Session>> open(const std::filesystem::path& building_dir, const SessionConfig& config);
  static Result<std::unique_ptr<Session>> open(Building building, const SessionConfig& config);

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  /// Bytes from the belt's serial line, cut anywhere. `arrival_s`: when the last of them arrived. Returns how many
  /// firings they completed.
  int on_bytes(std::span<const std::uint8_t> bytes, double arrival_s);

  /// One firing that is already decoded and time-stamped (a replayed log). Returns true when estimate() is renewed.
  bool on_firing(const Firing& firing);

  void on_motion(const MotionHint& hint);

  /// Time passes: notices a belt that fell silent. Call it at least twice a second while no bytes arrive.
  void on_tick(double now_s);

  /// The belt's line was opened anew or went away; the position estimate is kept.
  void on_belt_attached(double now_s);
  void on_belt_detached(double now_s);

  /// Forgets where the wearer is and has been, and starts over (e.g. the wearer says which entrance they stand at). A
  /// destination is kept and the way there told anew; a way back ends with the breadcrumbs that it followed. Fails, and
  /// changes nothing, when nobody can stand there (see check_start()).
  Status restart(const Start& start);

  // What the wearer wants. Each is answered by cues too; a failure says why in words for a log. A destination in a room
  // that nothing leads into, or only doors too narrow for a person, is refused to who is not in that room.
  /// To a place, an exit or a room, by the name or id that a wearer would say ("Lectern", "4", "exit").
  Status set_destination(std::string_view name, RoutePreferences preferences = {});
  /// The same for one of the building's places, exits or rooms, or any spot.
  Status set_destination(const Goal& goal, RoutePreferences preferences = {});
  /// To the nearest way out.
  Status way_out(RoutePreferences preferences = {});
  /// Back along the wearer's own breadcrumbs.
  Status back_track();
  void clear_destination();
  /// Answers with cues: room, facing, nearest door.
  void where_am_i();
  /// Answers with the last line that told the wearer to do something; false, and no cue, when there is none or it has
  /// been carried out.
  bool repeat();

  /// Takes the next cue that is to be spoken; false when there is none. Words for it: echoway/speech/speaker.hpp.
  bool next_cue(Cue& cue);
  /// Nothing is said twice within so many seconds, unless asked: for whoever puts cues into words, which may be the
  /// same.
  [[nodiscard]] double repeat_gap_s() const;
  /// False once the wearer has arrived and stays.
  [[nodiscard]] bool has_destination() const;
  /// Whether a way leads to the destination from where the session's start says that the wearer is. Fails, naming the
  /// rooms and what is between them, when none does; success where the start names no room, and without a destination.
  [[nodiscard]] Status check_way_from_start() const;
  /// How far the nearest thing in the way is that no plan knows, metres from the chest; negative when there is none, or
  /// the position is not known well enough to tell.
  [[nodiscard]] double obstacle_ahead_m() const;
  /// The way to the destination from where the wearer is; empty without one.
  [[nodiscard]] const Route& route() const;
  /// Where the wearer has been, oldest first, thinned.
  [[nodiscard]] std::span<const Spot> breadcrumbs() const;

  [[nodiscard]] const Building& building() const;
  [[nodiscard]] const SessionConfig& config() const;
  [[nodiscard]] const Estimate& estimate() const;
  /// Most probable first.
  [[nodiscard]] std::span<const Hypothesis> hypotheses() const;
  [[nodiscard]] const BeltHealth& belt_health() const;
  /// The newest firing of each sensor, index = sensor; time_s is NaN-free and negative before the first.
  [[nodiscard]] std::span<const Firing> last_scan() const;
  /// The same firings with what in the plan explains each, from where the wearer was when it was fired. The first call
  /// compiles the plan for it.
  [[nodiscard]] std::span<const ExplainedEcho> explain_scan();
  /// What of the plan no echo in a room can depend on for this belt, and what leaving it out saves. Compiles the whole
  /// building: for people who want to know, not while somebody walks.
  [[nodiscard]] SceneReport report_scene() const;

 private:
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace echoway
