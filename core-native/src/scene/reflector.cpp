#include "scene/reflector.hpp"

namespace echoway::scene {

Reflector make_segment_reflector(ReflectorKind kind, const Segment& s, bool seen_from_left) noexcept {
  Reflector r;
  r.kind = kind;
  r.a = s.a;
  r.b = s.b;
  r.length = s.length();
  r.seen_from_left = seen_from_left;
  const Vec2 left = perpendicular((1.0 / r.length) * s.direction());
  r.normal = seen_from_left ? left : -left;
  r.offset = -dot(r.normal, s.a);
  return r;
}

Reflector make_point_reflector(ReflectorKind kind, Vec2 at) noexcept {
  Reflector r;
  r.kind = kind;
  r.a = r.b = at;
  return r;
}

Reflector transformed(const Reflector& r, Vec2 rotation, Vec2 shift) noexcept {
  Reflector t = r;
  t.a = rotated(r.a, rotation) + shift;
  t.b = rotated(r.b, rotation) + shift;
  t.normal = rotated(r.normal, rotation);
  t.offset = -dot(t.normal, t.a);
  t.own_index = -1;
  return t;
}

}  // namespace echoway::scene
