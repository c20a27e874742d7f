#pragma once

#include <istream>
#include <string>

namespace echoway::tracks {

/// How far two outputs of rows() are apart.
struct Difference {
  bool comparable = false;    ///< The same walks and as many estimates in each.
  std::size_t rows = 0;
  std::size_t rooms = 0;      ///< Rows that name different rooms.
  double position_m = 0.0;    ///< Largest distance between two estimates in the same room.
  double heading_rad = 0.0;
};

[[nodiscard]] Difference compare(std::istream& a, std::istream& b);

}  // namespace echoway::tracks
