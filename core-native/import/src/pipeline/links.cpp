#include "pipeline/links.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kReach = 1.0;        // metres from a declared end to the floor
constexpr double kAbove = 0.3;        // of the smaller area: flights that lie above each other
constexpr double kSameShaft = 2.0;    // metres; a declared link within this of a found one is the same

// A flight or a car on one level.
struct Shaft {
  const PlanUnit* unit;
  std::size_t level;
  Shape area;
  int cell;
  Vec2 at;
  bool joined = false;
};

class Finder {
 public:
  Finder(const Plan& plan, const std::vector<LevelRooms>& levels, Report& report)
      : plan_(plan), levels_(levels), report_(report) {
    for (std::size_t i = 0; i < levels.size(); ++i) collect(i);
  }

  std::vector<PlacedLink> find() {
    for (const PlanLink& link : plan_.links) declare(link);
    for (std::size_t i = 0; i < shafts_.size(); ++i) {
      for (std::size_t j = i + 1; j < shafts_.size(); ++j) {
        if (one_above_other(shafts_[i], shafts_[j])) join(kind_of(*shafts_[i].unit), shafts_[i], shafts_[j]);
      }
    }
    for (const Shaft& shaft : shafts_) {
      if (!shaft.joined) unresolved(shaft.unit->source, shaft.level, shaft.at, "joins no other level");
    }
    return std::move(links_);
  }

 private:
  static LevelLinkKind kind_of(const PlanUnit& unit) {
    return unit.kind == UnitKind::elevator ? LevelLinkKind::elevator : LevelLinkKind::stairs;
  }

  void unresolved(const Source& source, std::size_t level, Vec2 at, const std::string& what) {
    report_.unresolved(source, levels_[level].floor.plan->short_name, at, what);
  }

  // The cell that holds most of a flight, and a point of it to walk to.
  void collect(std::size_t level) {
    for (const PlanUnit& unit : levels_[level].floor.plan->units) {
      if (unit.kind != UnitKind::stairs && unit.kind != UnitKind::elevator) continue;
      Shape area = shape_of(unit.area);
      std::optional<Shape> best;
      int cell = -1;
      const auto& cells = levels_[level].floor.cells;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!geos::intersects(cells[i].floor, area)) continue;
        Shape common = geos::intersection(cells[i].floor, area);
        if (common.area() < 0.2 || (best && common.area() <= best->area())) continue;
        best = std::move(common);
        cell = static_cast<int>(i);
      }
      if (cell < 0) {
        unresolved(unit.source, level, geos::inscribed_circle(geos::areas(area).front()).centre,
                   "lies in no room: joins no level");
        continue;
      }
      const std::vector<Shape> parts = geos::areas(*best);
      const Shape& main = *std::max_element(parts.begin(), parts.end(),
                                            [](const Shape& a, const Shape& b) { return a.area() < b.area(); });
      shafts_.push_back({&unit, level, std::move(area), cell, geos::inscribed_circle(main).centre});
    }
  }

  bool one_above_other(const Shaft& a, const Shaft& b) const {
    if (a.level == b.level || a.unit->kind != b.unit->kind) return false;
    const bool next = (a.level > b.level ? a.level - b.level : b.level - a.level) == 1;
    if (!a.unit->shaft.empty() || !b.unit->shaft.empty()) {
      return a.unit->shaft == b.unit->shaft && (next || a.unit->kind == UnitKind::elevator);
    }
    if (!next && a.unit->kind == UnitKind::stairs) return false;
    if (!geos::intersects(a.area, b.area)) return false;
    return geos::intersection(a.area, b.area).area() > kAbove * std::min(a.area.area(), b.area.area());
  }

  bool known(const PlacedLink& link) const {
    return std::any_of(links_.begin(), links_.end(), [&](const PlacedLink& other) {
      const bool same = other.kind == link.kind && other.level_a == link.level_a && other.level_b == link.level_b &&
                        other.cell_a == link.cell_a && other.cell_b == link.cell_b;
      return same && distance(other.at_a, link.at_a) < kSameShaft && distance(other.at_b, link.at_b) < kSameShaft;
    });
  }

  void add(PlacedLink link) {
    if (link.level_a > link.level_b) {
      std::swap(link.level_a, link.level_b);
      std::swap(link.cell_a, link.cell_b);
      std::swap(link.at_a, link.at_b);
    }
    if (!known(link)) links_.push_back(link);
  }

  void join(LevelLinkKind kind, Shaft& a, Shaft& b) {
    a.joined = b.joined = true;
    add({kind, a.level, b.level, a.cell, b.cell, a.at, b.at});
  }

  struct End {
    std::size_t level = 0;
    int cell = -1;
    Vec2 at{};
    Shaft* shaft = nullptr;
  };

  std::optional<End> resolve(const PlanLinkEnd& end, LevelLinkKind kind) {
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      if (levels_[i].floor.plan->ordinal != end.ordinal) continue;
      for (Shaft& shaft : shafts_) {
        if (shaft.level != i || kind_of(*shaft.unit) != kind) continue;
        const bool named = !end.unit.empty() && shaft.unit->source.id == end.unit;
        if (named || (end.at && geos::distance(shaft.area, *end.at) < kReach)) {
          return End{i, shaft.cell, shaft.at, &shaft};
        }
      }
      if (!end.at) return std::nullopt;
      const int cell = levels_[i].floor.cell_near(*end.at, kReach);
      if (cell < 0) return std::nullopt;
      const Shape& floor = levels_[i].floor.cells[static_cast<std::size_t>(cell)].floor;
      return End{i, cell, geos::standing_point(floor, *end.at), nullptr};
    }
    return std::nullopt;
  }

  void declare(const PlanLink& link) {
    const auto a = resolve(link.a, link.kind), b = resolve(link.b, link.kind);
    if (!a || !b) {
      report_.unresolved(link.source, "", link.a.at, "one of its ends lies in no room: joins no level");
      return;
    }
    if (a->shaft != nullptr) a->shaft->joined = true;
    if (b->shaft != nullptr) b->shaft->joined = true;
    add({link.kind, a->level, b->level, a->cell, b->cell, a->at, b->at});
  }

  const Plan& plan_;
  const std::vector<LevelRooms>& levels_;
  Report& report_;
  std::vector<Shaft> shafts_;
  std::vector<PlacedLink> links_;
};

}  // namespace

std::vector<PlacedLink> find_links(const Plan& plan, const std::vector<LevelRooms>& levels, Report& report) {
  return Finder(plan, levels, report).find();
}

}  // namespace echoway::import
