#pragma once

#include <string>

#include "plans/scratch_folder.hpp"
#include "reader.hpp"

/// Plans that are well formed and hold what an input chooses: most byte strings that are put through a reader of files
/// are refused before anything of a building is worked out.
namespace echoway::fuzz {

/// An OpenStreetMap file.
[[nodiscard]] std::string draw_osm(Reader& in);
/// Three levels of the WRLD format.
void draw_wrld(Reader& in, const plans::ScratchFolder& folder);
/// Two levels of the Indoor Mapping Data Format.
void draw_imdf(Reader& in, const plans::ScratchFolder& folder);

// Of all of them.
inline constexpr int kMostFeatures = 48;
/// Degrees.
struct Spot {
  double lon = 0.0, lat = 0.0;
};
/// Most lie on a grid of half a metre, so that outlines share corners and run along each other.
[[nodiscard]] Spot take_spot(Reader& in);
template <class Words>
[[nodiscard]] auto one_of(Reader& in, const Words& words) {
  return words[in.byte() % words.size()];
}

}  // namespace echoway::fuzz
