#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "building/source.hpp"
#include "echoway/text/tokens.hpp"

namespace echoway {

/// Coordinates beyond this are no building, metres; it keeps every product of two of them far from overflow.
inline constexpr double kMaxCoordinate = 1e8;

/// Takes the words of one line in turn. After the first word that does not fit, everything else fails too and problem()
/// says what was wrong with it.
class LineParser {
 public:
  explicit LineParser(std::vector<text::Token> tokens) : tokens_(std::move(tokens)) {}

  [[nodiscard]] bool at_end() const noexcept { return next_ == tokens_.size(); }
  [[nodiscard]] std::size_t size() const noexcept { return tokens_.size(); }

  std::string word(std::string_view what);
  std::string quoted(std::string_view what);
  double number(std::string_view what);
  long long integer(std::string_view what);
  /// Two numbers, taken as metres after multiplication by `scale`.
  Vec2 point(double scale);
  Segment segment(double scale);
  PlaceSource place(double scale);
  /// The word `expected` itself.
  void keyword(std::string_view expected);
  void end();

  void refuse(std::string problem);
  [[nodiscard]] const std::optional<std::string>& problem() const noexcept { return problem_; }

 private:
  const text::Token* take(std::string_view what);
  double length(std::string_view what, double scale);

  std::vector<text::Token> tokens_;
  std::size_t next_ = 0;
  std::optional<std::string> problem_;
};

/// `word` in single quotes, shortened, for a message.
[[nodiscard]] std::string shown(std::string_view word);

}  // namespace echoway
