#include "building/features.hpp"

#include <algorithm>
#include <cmath>

namespace echoway {

MeetingKind kind_of(const WallMeeting& meeting) noexcept {
  if (std::abs(meeting.angle - 0.5 * kPi) <= kRightAngleTolerance) return MeetingKind::corner;
  if (meeting.angle >= kPi + kLeastEdgeTurn) return MeetingKind::edge;
  return meeting.angle > kPi - kLeastEdgeTurn ? MeetingKind::straight : MeetingKind::oblique;
}

FeaturePlace place_feature(const FloorTrace& floor, Vec2 listed) noexcept {
  FeaturePlace place;
  place.at = listed;
  double nearest = kSameFeature;
  for (const WallMeeting& meeting : floor.meetings) {
    const double d = distance(meeting.at, listed);
    if (d <= nearest) {
      nearest = d;
      place.at = meeting.at;
    }
  }
  for (const WallMeeting& meeting : floor.meetings) {
    if (meeting.at != place.at) continue;
    const MeetingKind kind = kind_of(meeting);
    place.corner |= kind == MeetingKind::corner;
    place.oblique |= kind == MeetingKind::oblique;
    place.edge |= kind == MeetingKind::edge;
  }
  return place;
}

void add_feature(std::vector<Vec2>& points, Vec2 p) {
  const bool known = std::any_of(points.begin(), points.end(), [&](Vec2 q) { return distance(p, q) <= kSameFeature; });
  if (!known) points.push_back(p);
}

void derive_features(const RoomSource& source, const FloorTrace& floor, Room& room) {
  for (const Located<Vec2>& listed : source.corners) {
    const FeaturePlace place = place_feature(floor, listed.what);
    if (place.corner || !(place.oblique || place.edge)) {
      add_feature(room.corners, place.at);
    } else if (place.edge) {
      add_feature(room.edges, place.at);
    }
  }
  for (const Located<Vec2>& listed : source.edges) {
    const FeaturePlace place = place_feature(floor, listed.what);
    if (place.edge || !place.corner) {
      add_feature(room.edges, place.at);
    } else {
      add_feature(room.corners, place.at);
    }
  }
  for (const WallMeeting& meeting : floor.meetings) {
    const MeetingKind kind = kind_of(meeting);
    if (kind == MeetingKind::corner) add_feature(room.corners, meeting.at);
    if (kind == MeetingKind::edge) add_feature(room.edges, meeting.at);
  }
}

}  // namespace echoway
