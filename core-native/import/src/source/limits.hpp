#pragma once

#include <cstddef>

/// Bounds on what a plan may ask of this machine. Real plans stay far below; hostile ones are refused at the bound,
/// before memory is spent.
namespace echoway::import {

inline constexpr std::size_t kMaxFileBytes = 32u << 20;     ///< One file, unpacked.
inline constexpr std::size_t kMaxArchiveBytes = 128u << 20; ///< All files that are read from one archive, unpacked.
inline constexpr std::size_t kMaxArchiveEntries = 2000;
inline constexpr int kMaxNesting = 32;                      ///< JSON and XML; GeoJSON needs 9.
inline constexpr std::size_t kMaxJsonValues = 4'000'000;    ///< Of one file.
inline constexpr std::size_t kMaxElements = 1'000'000;      ///< XML elements of one file.
inline constexpr std::size_t kMaxFeatures = 50'000;         ///< Of one plan.
inline constexpr std::size_t kMaxVertices = 500'000;        ///< Of one plan.
inline constexpr int kMaxLevels = 200;                      ///< The tallest building has 163.
inline constexpr double kMaxExtent = 2000.0;                ///< Metres from a building's centre.
inline constexpr std::size_t kMaxNameLength = 80;           ///< Bytes; longer names are cut, they are to be spoken.

}  // namespace echoway::import
