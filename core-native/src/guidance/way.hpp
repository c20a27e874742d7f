#pragma once

#include <optional>
#include <span>
#include <vector>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/hindrances.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// The way from wherever the wearer is, to a destination or back along breadcrumbs, laid out anew each time and led
/// round things that no plan knows. Knows whether it is the one that the wearer was told.
class Way {
 public:
  /// REQUIRES: both outlive this.
  Way(const Router& router, const GuideConfig& config) : router_(&router), config_(&config), hindrances_(config) {}

  void lead_to(RouteTree tree);
  void lead_back(std::vector<Spot> crumbs);
  void clear();
  /// The wearer is not where they were thought to be: a way to a destination is kept, one back ends.
  void start_over();
  [[nodiscard]] bool active() const noexcept { return mode_ != Mode::none; }

  /// Whether there is one to the destination from `at` in a room, or from somewhere in it; a way back is not looked at.
  [[nodiscard]] Status check(RoomIndex room, std::optional<Vec2> at) const;

  /// Lays the way out from here; false when there is none.
  [[nodiscard]] bool find(const Estimate& estimate);
  /// Where the way leads at first from here, in the room's frame, if there is one; the way that find() laid out stays.
  [[nodiscard]] std::optional<double> heading_from(const Estimate& estimate);
  /// Whether the last find() came upon other doors than the one before.
  [[nodiscard]] bool has_changed() const noexcept { return changed_; }

  [[nodiscard]] const Route& route() const noexcept { return route_; }
  /// Unfolded into the frame of the wearer's room, up to the goal or the first stairs.
  [[nodiscard]] std::span<const LinePoint> line() const noexcept { return line_; }
  /// The first door of the line and how far along it is; at the line's end, and no door, without one.
  struct DoorAhead {
    const LinePoint* door = nullptr;
    double along = 1e9;
  };
  [[nodiscard]] DoorAhead first_door() const noexcept;
  [[nodiscard]] bool leads_through(std::int32_t door) const noexcept;

  /// It leads through other doors than the wearer was told, until told_new().
  [[nodiscard]] bool is_new() const noexcept { return new_; }
  void told_new() noexcept { new_ = false; }

  /// How far the wearer has come: farther from the goal than they were by more than a position's error is astray.
  void note_progress() noexcept;
  void forget_progress() noexcept { least_cost_ = route_.cost; }
  [[nodiscard]] bool is_astray(double sigma_m) const noexcept;

  [[nodiscard]] Hindrances& hindrances() noexcept { return hindrances_; }
  [[nodiscard]] const Hindrances& hindrances() const noexcept { return hindrances_; }

 private:
  enum class Mode : std::uint8_t { none, tree, crumbs };
  [[nodiscard]] BoundFor bound_for(const Estimate& estimate) const;
  [[nodiscard]] bool route_from(const Estimate& estimate, const BoundFor& bound, Route& route) const;
  void compare_doors();

  const Router* router_;
  const GuideConfig* config_;
  Mode mode_ = Mode::none;
  RouteTree tree_;
  std::vector<Spot> crumbs_;
  Route route_;
  std::vector<LinePoint> line_;
  Route guess_;                          ///< From where the wearer may be, while nobody knows,
  std::vector<LinePoint> guess_line_;    ///< and its line.
  Hindrances hindrances_;
  std::vector<std::int32_t> doors_;      ///< Of the way that was told, in order.
  std::vector<std::int32_t> new_doors_;
  bool changed_ = false;
  bool new_ = false;
  double least_cost_ = 1e300;            ///< Nearest to the goal so far.
};

}  // namespace echoway::guidance
