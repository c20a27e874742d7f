#include "source/osm_rings.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace echoway::import {
namespace {

using Nodes = std::vector<OsmId>;

constexpr std::size_t kFewestNodes = 3;

// Walks from way to way. Where it comes to a node again, what lies between is a ring, and no more of its way; where it
// gets no further it goes a way back, and that one is left over.
class RingWalk {
 public:
  explicit RingWalk(const std::vector<Nodes>& ways) : ways_(ways), taken_(ways.size(), false) {
    for (std::size_t way = 0; way < ways.size(); ++way) {
      if (ways[way].empty()) {
        left_over_.push_back(way);
      } else {
        ends_.emplace(ways[way].front(), way);
        ends_.emplace(ways[way].back(), way);
      }
    }
  }

  OsmRings rings() {
    for (const Nodes& way : ways_) {
      if (!way.empty()) walk_from(way.front());
    }
    OsmRings joined;
    for (auto& [first_way, ring] : rings_) joined.rings.push_back(std::move(ring));
    std::sort(left_over_.begin(), left_over_.end());
    joined.left_over = std::move(left_over_);
    return joined;
  }

 private:
  struct Step {
    std::size_t way;
    OsmId from;
  };

  void walk_from(OsmId node) {
    for (;;) {
      if (const auto way = take_at(node)) {
        node = go(*way, node);
      } else if (!path_.empty()) {
        node = go_back();
      } else {
        return;
      }
    }
  }

  // The first that is left of those that end there.
  std::optional<std::size_t> take_at(OsmId node) {
    for (auto end = ends_.lower_bound(node); end != ends_.end() && end->first == node; end = ends_.erase(end)) {
      if (taken_[end->second]) continue;
      taken_[end->second] = true;
      return end->second;
    }
    return std::nullopt;
  }

  OsmId go(std::size_t way, OsmId from) {
    step_from_[from] = path_.size();
    path_.push_back({way, from});
    const Nodes& nodes = ways_[way];
    const OsmId to = nodes.front() == from ? nodes.back() : nodes.front();
    if (const auto met = step_from_.find(to); met != step_from_.end()) take_off_ring(met->second);
    return to;
  }

  OsmId go_back() {
    const Step last = path_.back();
    left_over_.push_back(last.way);
    step_from_.erase(last.from);
    path_.pop_back();
    return last.from;
  }

  // All of the path from that step on.
  void take_off_ring(std::size_t first_step) {
    Nodes ring;
    std::vector<std::size_t> of;
    for (std::size_t i = first_step; i < path_.size(); ++i) {
      append(ring, path_[i]);
      of.push_back(path_[i].way);
      step_from_.erase(path_[i].from);
    }
    path_.resize(first_step);
    if (ring.size() >= kFewestNodes) {
      rings_.emplace(*std::min_element(of.begin(), of.end()), std::move(ring));
    } else {
      left_over_.insert(left_over_.end(), of.begin(), of.end());
    }
  }

  // But for the last node, with which the next begins.
  void append(Nodes& ring, const Step& step) const {
    const Nodes& way = ways_[step.way];
    if (way.front() == step.from) {
      ring.insert(ring.end(), way.begin(), way.end() - 1);
    } else {
      ring.insert(ring.end(), way.rbegin(), way.rend() - 1);
    }
  }

  const std::vector<Nodes>& ways_;
  std::vector<bool> taken_;
  std::multimap<OsmId, std::size_t> ends_;  // Ways by their end nodes; those taken go when they are met.
  std::vector<Step> path_;
  std::map<OsmId, std::size_t> step_from_;  // Where on the path its steps begin.
  std::map<std::size_t, Nodes> rings_;      // By the first way of each.
  std::vector<std::size_t> left_over_;
};

}  // namespace

OsmRings join_into_rings(const std::vector<Nodes>& ways) { return RingWalk(ways).rings(); }

}  // namespace echoway::import
