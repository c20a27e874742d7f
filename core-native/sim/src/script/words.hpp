#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "echoway/result.hpp"

namespace echoway::sim {

/// One line of a walk file, taken word by word; `#` starts a comment. Errors carry file and line.
class Words {
 public:
  Words(std::string_view line, const std::string& file, int number);

  [[nodiscard]] bool empty() const noexcept { return words_.empty(); }
  [[nodiscard]] std::string keyword();

  // Each takes the next word; `what` says what it should be.
  Status text(std::string_view what, std::string& out);
  Status number(std::string_view what, double low, double high, double& out);
  Status integer(std::string_view what, int low, int high, int& out);
  Status seed(std::uint64_t& out);
  /// `3`, `0,1,14` or `all` (an empty list).
  Status sensors(int count, std::vector<int>& out);

  /// Fails when words are left over.
  Status finish() const;

  [[nodiscard]] Error error(std::string message) const { return {std::move(message), file_, number_}; }

 private:
  std::string file_;
  int number_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

}  // namespace echoway::sim
