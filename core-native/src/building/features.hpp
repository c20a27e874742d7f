#pragma once

#include "building/source.hpp"
#include "geometry/floor_tracing.hpp"

namespace echoway {

/// A corner this far from a right angle still sends most of an echo straight back: the beam comes back turned by twice
/// as much, which is within half the 15 degree beam.
inline constexpr double kRightAngleTolerance = degrees(3.5);

/// A convex corner that turns by less is taken for a piece of a curve: it diffracts next to nothing.
inline constexpr double kLeastEdgeTurn = degrees(10.0);

/// A listed corner or edge this near to where walls meet means that place.
inline constexpr double kSameFeature = kSnapDistance;

enum class MeetingKind : std::uint8_t {
  corner,    ///< Concave right angle: sends sound straight back (thesis type 2).
  oblique,   ///< Concave, not a right angle: sends it elsewhere.
  edge,      ///< Convex, or a free end: diffracts (type 3).
  straight,  ///< Hardly a bend.
};

[[nodiscard]] MeetingKind kind_of(const WallMeeting& meeting) noexcept;

/// What the walls make of a listed point: whether they meet there with a floor angle of each kind.
struct FeaturePlace {
  bool corner = false;
  bool oblique = false;
  bool edge = false;
  Vec2 at{};  ///< Where the walls meet; the listed point when they do not.
};

[[nodiscard]] FeaturePlace place_feature(const FloorTrace& floor, Vec2 listed) noexcept;

/// Corners and edges of a room: those that its file lists, at the places and of the kind that the walls give them, then
/// those that it leaves out. A listed corner that is no right angle is left out, since it returns no sound.
void derive_features(const RoomSource& source, const FloorTrace& floor, Room& room);

/// Adds `p` unless one of `points` is the same feature.
void add_feature(std::vector<Vec2>& points, Vec2 p);

}  // namespace echoway
