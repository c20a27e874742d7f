#pragma once

#include <string>
#include <string_view>

#include "source/osm_document.hpp"
#include "source/plan.hpp"

/// What the tags of Simple Indoor Tagging (https://wiki.openstreetmap.org/wiki/Simple_Indoor_Tagging) mean for a plan.
namespace echoway::import {

/// A tag's value; empty without it.
[[nodiscard]] std::string tag(const OsmTags& tags, std::string_view key);
[[nodiscard]] bool has(const OsmTags& tags, std::string_view key);

/// A length that says no unit, metres or centimetres, in metres; 0 for everything else and what is not above 0.
[[nodiscard]] double metres(const std::string& text);

[[nodiscard]] bool is_indoor(const OsmTags& tags);
[[nodiscard]] bool is_entrance(const OsmTags& tags);
/// An entrance is one.
[[nodiscard]] bool is_door(const OsmTags& tags);
/// What a piece of floor is that is indoors.
[[nodiscard]] UnitKind unit_kind(const OsmTags& tags);
/// The word that says most of what is there; empty when none does.
[[nodiscard]] std::string category_of(const OsmTags& tags);

/// Whether a way is and is called nothing else than the relation that it belongs to.
[[nodiscard]] bool says_no_more(const OsmTags& way, const OsmTags& relation);

}  // namespace echoway::import
