#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "echoway/geometry/vec2.hpp"

namespace echoway::import {

/// Where a piece of a plan comes from: the file and the feature's own id.
struct Source {
  std::string file;
  std::string id;
};

/// One thing that the importer changed, or could not settle, so that somebody who knows the building can look at it.
struct ReportItem {
  enum class Kind {
    repaired,    ///< The plan was mended; the building is as good as the plan meant it to be.
    unresolved,  ///< The plan leaves something open that a person should settle; the building does without it.
    note,        ///< What was understood, for the record.
  };
  Kind kind = Kind::note;
  Source source;
  std::string level;       ///< Short name of the level, empty when it concerns the whole plan.
  std::optional<Vec2> at;  ///< Metres in the level's frame.
  std::string message;

  /// `file: feature 12: repaired: level 2 at (3.20, 4.10): message`
  [[nodiscard]] std::string to_string() const;
};

/// Everything the importer did to a plan, in the order in which it met it.
class Report {
 public:
  void add(ReportItem item) { items_.push_back(std::move(item)); }
  void repaired(Source source, std::string level, std::optional<Vec2> at, std::string message) {
    add({ReportItem::Kind::repaired, std::move(source), std::move(level), at, std::move(message)});
  }
  void unresolved(Source source, std::string level, std::optional<Vec2> at, std::string message) {
    add({ReportItem::Kind::unresolved, std::move(source), std::move(level), at, std::move(message)});
  }
  void note(Source source, std::string level, std::optional<Vec2> at, std::string message) {
    add({ReportItem::Kind::note, std::move(source), std::move(level), at, std::move(message)});
  }
  [[nodiscard]] const std::vector<ReportItem>& items() const noexcept { return items_; }
  [[nodiscard]] std::size_t count(ReportItem::Kind kind) const noexcept;

 private:
  std::vector<ReportItem> items_;
};

}  // namespace echoway::import
