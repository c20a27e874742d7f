#pragma once

#include <map>
#include <string>
#include <vector>

#include "echoway/building/loader.hpp"

namespace echoway {

/// Collects what is wrong with a building. At most kMaxPerFile findings a file are kept: a broken file of a million
/// lines needs no million messages.
class Findings {
 public:
  static constexpr int kMaxPerFile = 200;

  void warn(const std::string& file, int line, std::string message) {
    add(Finding::Severity::warning, file, line, std::move(message));
  }
  void unusable(const std::string& file, int line, std::string message) {
    any_unusable_ = true;
    add(Finding::Severity::unusable, file, line, std::move(message));
  }
  void unusable(const Error& error) { unusable(error.file, error.line, error.message); }

  [[nodiscard]] bool any_unusable() const noexcept { return any_unusable_; }

  /// The unusable ones first, else in order of file and line.
  [[nodiscard]] std::vector<Finding> sorted() &&;

 private:
  void add(Finding::Severity severity, const std::string& file, int line, std::string message);

  std::vector<Finding> findings_;
  std::map<std::pair<std::string, Finding::Severity>, int> count_;
  bool any_unusable_ = false;
};

}  // namespace echoway
