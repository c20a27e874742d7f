#include "source/osm_storeys.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "source/osm_levels.hpp"
#include "source/osm_tags.hpp"

namespace echoway::import {

std::vector<double> OsmStoreys::of(const OsmTags& tags, const Source& source) {
  if (is_unreadable(source)) return {};
  std::set<double> numbers;
  for (const char* key : {"level", "repeat_on"}) {
    const std::string text = tag(tags, key);
    if (text.empty()) continue;
    const auto parsed = parse_osm_levels(text);
    if (!parsed) {
      report_->unresolved(source, "", {}, std::string(key) + "=" + text + " cannot be read: left out");
      unreadable_.insert(source.id);
      return {};
    }
    numbers.insert(parsed->begin(), parsed->end());
  }
  return {numbers.begin(), numbers.end()};
}

void OsmStoreys::put(const std::vector<OsmId>& nodes, const std::vector<double>& numbers) {
  for (const OsmId node : nodes) of_nodes_[node].insert(numbers.begin(), numbers.end());
}

std::vector<double> OsmStoreys::of_node(OsmId node) const {
  const auto found = of_nodes_.find(node);
  if (found == of_nodes_.end()) return {};
  return {found->second.begin(), found->second.end()};
}

void OsmStoreys::join(LevelLinkKind kind, const Source& source, double from, Vec2 at_from, double to, Vec2 at_to) {
  joints_.push_back({kind, source, from, at_from, to, at_to});
}

void OsmStoreys::number_into(Plan& plan) {
  const bool whole = std::all_of(levels_.begin(), levels_.end(),
                                 [](const auto& level) { return level.first == std::floor(level.first); });
  const auto ground = std::distance(levels_.begin(), levels_.lower_bound(0.0));
  std::ptrdiff_t index = 0;
  std::map<double, int> ordinal;
  for (auto& [number, level] : levels_) {
    level.ordinal = whole ? static_cast<int>(number) : static_cast<int>(index - ground);
    level.short_name = osm_level_name(number);
    level.file = plan.file;
    level.ground = number == 0.0;
    ordinal[number] = level.ordinal;
    if (!whole) {
      report_->note({plan.file, ""}, level.short_name, {},
                    "counted as level " + std::to_string(level.ordinal) + ", for there are levels between whole ones");
    }
    plan.levels.push_back(std::move(level));
    ++index;
  }
  for (const Joint& j : joints_) {
    if (ordinal.count(j.from) == 0 || ordinal.count(j.to) == 0) continue;
    plan.links.push_back({j.source, j.kind, {ordinal[j.from], "", j.at_from}, {ordinal[j.to], "", j.at_to}});
  }
}

}  // namespace echoway::import
