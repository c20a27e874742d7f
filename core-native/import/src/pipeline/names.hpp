#pragma once

#include <set>
#include <string>
#include <string_view>

#include "source/plan.hpp"

namespace echoway::import {

/// Lower-case letters, digits and hyphens of a name, accents dropped: what a room id and a file name can hold. Empty
/// when the name has none (another script).
[[nodiscard]] std::string slug(std::string_view name);

/// A name fit for a quoted string and for speech: valid UTF-8, no control characters, no quotes, bounded length.
[[nodiscard]] std::string clean_name(std::string_view name);

/// What a unit or an amenity of this category is called when the plan gives it no name: "Toilet" for
/// `restroom.unisex`. Empty when the category says nothing to a visitor (`room`, `walkway`, `unspecified`).
[[nodiscard]] std::string spoken_category(std::string_view category);

/// `wanted`, or `wanted-2`, `wanted-3` and so on when it is taken; taken from then on.
[[nodiscard]] std::string unique_id(const std::string& wanted, std::set<std::string>& taken);

}  // namespace echoway::import
