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

  using Kind = Finding::Kind;

  void warn(Kind kind, const std::string& file, int line, std::string message) {
    add({Finding::Severity::warning, kind, file, line, std::move(message)});
  }
  void unusable(Kind kind, const std::string& file, int line, std::string message) {
    any_unusable_ = true;
    add({Finding::Severity::unusable, kind, file, line, std::move(message)});
  }
  /// Of a file that cannot be read.
  void unusable(const Error& error) { unusable(Kind::unreadable, error.file, error.line, error.message); }

  [[nodiscard]] bool any_unusable() const noexcept { return any_unusable_; }

  /// The unusable ones first, else in order of file and line.
  [[nodiscard]] std::vector<Finding> sorted() &&;

 private:
  void add(Finding finding);

  std::vector<Finding> findings_;
  std::map<std::pair<std::string, Finding::Severity>, int> count_;
  bool any_unusable_ = false;
};

}  // namespace echoway
