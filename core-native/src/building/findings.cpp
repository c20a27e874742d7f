#include "building/findings.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace echoway {

void Findings::add(Finding finding) {
  const int count = ++count_[{finding.file, finding.severity}];
  if (count > kMaxPerFile) return;
  if (count == kMaxPerFile) {
    finding.kind = Kind::more;
    finding.message = "and more like these; mend the ones above first";
  }
  findings_.push_back(std::move(finding));
}

std::vector<Finding> Findings::sorted() && {
  const auto rank = [](const Finding& f) {
    return std::tuple{f.severity != Finding::Severity::unusable, std::string_view(f.file), f.line};
  };
  std::stable_sort(findings_.begin(), findings_.end(),
                   [&](const Finding& a, const Finding& b) { return rank(a) < rank(b); });
  return std::move(findings_);
}

}  // namespace echoway
