#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "echoway/import/report.hpp"
#include "source/osm_document.hpp"
#include "source/plan.hpp"

namespace echoway::import {

/// The levels of a plan, which come to be as features say that they stand on them.
class OsmStoreys {
 public:
  /// REQUIRES: `report` outlives this.
  explicit OsmStoreys(Report& report) : report_(&report) {}

  /// The numbers that a feature's tags put it on, from the lowest. None when they cannot be read, which is reported
  /// once.
  [[nodiscard]] std::vector<double> of(const OsmTags& tags, const Source& source);
  /// Whether of() has reported that.
  [[nodiscard]] bool is_unreadable(const Source& source) const { return unreadable_.count(source.id) != 0; }

  /// On which levels the outlines run that go through these nodes, so that a door there need not say it.
  void put(const std::vector<OsmId>& nodes, const std::vector<double>& numbers);
  [[nodiscard]] std::vector<double> of_node(OsmId node) const;

  [[nodiscard]] bool empty() const { return levels_.empty(); }
  [[nodiscard]] bool has(double number) const { return levels_.count(number) != 0; }
  /// What stands on a level, which is made when it is first asked for.
  [[nodiscard]] PlanLevel& at(double number) { return levels_[number]; }

  /// Stairs or an elevator from a place on one level to one on another.
  void join(LevelLinkKind kind, const Source& source, double from, Vec2 at_from, double to, Vec2 at_to);

  /// Moves all into `plan`. Level numbers may be fractions (mezzanines); buildings count whole levels, so all are
  /// counted up from level 0 then.
  void number_into(Plan& plan);

 private:
  struct Joint {
    LevelLinkKind kind;
    Source source;
    double from;
    Vec2 at_from;
    double to;
    Vec2 at_to;
  };

  Report* report_;
  std::map<double, PlanLevel> levels_;
  std::map<OsmId, std::set<double>> of_nodes_;
  std::vector<Joint> joints_;
  std::set<std::string> unreadable_;  ///< Features whose level was reported.
};

}  // namespace echoway::import
