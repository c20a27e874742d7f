#pragma once

#include <cstdint>

#include "byte_writer.hpp"
#include "echoway/geometry/vec2.hpp"

namespace echoway::jni {

inline void write(ByteWriter& w, Vec2 point) noexcept {
  w.f64(point.x);
  w.f64(point.y);
}

/// The length (i32), then each item.
template <class List, class Each>
void write_list(ByteWriter& w, const List& list, Each each) noexcept {
  w.i32(static_cast<std::int32_t>(list.size()));
  for (const auto& item : list) each(item);
}

}  // namespace echoway::jni
