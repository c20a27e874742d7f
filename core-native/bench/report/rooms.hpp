#pragma once

#include <optional>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/random.hpp"
#include "following.hpp"
#include "stops.hpp"
#include "thesis/objective.hpp"
#include "thesis/pose_matcher.hpp"

namespace echoway::report {

/// The thesis's matching in one room, with all that it needs.
class RoomMatcher {
 public:
  RoomMatcher(const Building& plan, RoomIndex room, const BeltConfig& belt, const ThesisParameters& parameters);

  /// The best pose within the thesis's bounds about `start`.
  [[nodiscard]] thesis::Match match(const thesis::Scan& scan, const Pose2& start);
  /// The objective at one pose; nothing with fewer readings to compare than the thesis asks for, or outside the room.
  [[nodiscard]] std::optional<double> objective(const thesis::Scan& scan, const Pose2& pose);

  [[nodiscard]] const thesis::PoseMatcher& matcher() const noexcept { return matcher_; }

 private:
  BeltConfig belt_;
  ThesisParameters parameters_;
  thesis::PoseMatcher matcher_;
  thesis::MatchWorkspace workspace_;
  thesis::PositionEchoes echoes_;
};

/// "The approximate initial user pose" (section 5.1): off by up to 4 ft and 15 degrees, within the room.
[[nodiscard]] Pose2 approximate(const Room& room, const Pose2& truth, Random& random);

/// Places to stand at, half a metre clear of everything on the plan, facing anywhere.
[[nodiscard]] std::vector<Pose2> random_places(const Room& room, int count, std::uint64_t seed);
/// What the thesis makes of two passes at each of them, without the walk in between.
[[nodiscard]] std::vector<thesis::Scan> scans_at(const Building& world, std::string_view room,
                                                 const std::vector<Pose2>& places, const sim::World& contents,
                                                 std::uint64_t seed);

/// A walk in one room from place to place, standing at each for two passes, facing anywhere. Throws when the room has
/// no such way.
[[nodiscard]] sim::Walk walk_of_places(const Building& world, std::string_view room, int places,
                                       const sim::World& contents, std::uint64_t seed);

/// The thesis's circular walk (section 6.2.2): in steps of a foot and ten degrees round the sample room, one of them a
/// sharp turn of thirty, standing after each.
struct CircularWalk {
  sim::Walk walk;
  int sharp_turn = 0;  ///< Index of the stop after it.
};
[[nodiscard]] CircularWalk circular_walk(int sensors, sim::Profile profile, std::uint64_t seed);

}  // namespace echoway::report
