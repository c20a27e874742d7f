#include "echoway/import/report.hpp"

#include <algorithm>
#include <cstdio>

namespace echoway::import {
namespace {

const char* word(ReportItem::Kind kind) {
  switch (kind) {
    case ReportItem::Kind::repaired: return "repaired";
    case ReportItem::Kind::unresolved: return "unresolved";
    case ReportItem::Kind::note: break;
  }
  return "note";
}

}  // namespace

std::string ReportItem::to_string() const {
  std::string line;
  if (!source.file.empty()) line += source.file + ": ";
  if (!source.id.empty()) line += "feature " + source.id + ": ";
  line += word(kind);
  line += ": ";
  if (!level.empty()) line += "level " + level;
  if (at) {
    char place[64];
    std::snprintf(place, sizeof place, "%sat (%.2f, %.2f)", level.empty() ? "" : " ", at->x, at->y);
    line += place;
  }
  if (!level.empty() || at) line += ": ";
  return line + message;
}

std::size_t Report::count(ReportItem::Kind kind) const noexcept {
  return static_cast<std::size_t>(
      std::count_if(items_.begin(), items_.end(), [kind](const ReportItem& item) { return item.kind == kind; }));
}

}  // namespace echoway::import
