#include "building/findings.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace echoway {

void Findings::add(Finding::Severity severity, const std::string& file, int line, std::string message) {
  const int count = ++count_[{file, severity}];
  if (count > kMaxPerFile) return;
  if (count == kMaxPerFile) message = "and more like these; mend the ones above first";
  findings_.push_back({severity, file, line, std::move(message)});
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
