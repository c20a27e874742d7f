#include "guidance/breadcrumbs.hpp"

#include <cstddef>

namespace echoway::guidance {
namespace {

constexpr double kSpacing = 1.5;  // metres
constexpr std::size_t kMost = 1024;

}  // namespace

Breadcrumbs::Breadcrumbs() { crumbs_.reserve(kMost); }

void Breadcrumbs::drop(const Spot& here) {
  if (!crumbs_.empty() && crumbs_.back().room == here.room && distance(crumbs_.back().at, here.at) < kSpacing) return;
  if (crumbs_.size() == kMost) {  // a very long walk: every other crumb still shows the way
    std::size_t kept = 0;
    for (std::size_t i = 0; i < crumbs_.size(); i += 2) crumbs_[kept++] = crumbs_[i];
    crumbs_.resize(kept);
  }
  crumbs_.push_back(here);
}

}  // namespace echoway::guidance
