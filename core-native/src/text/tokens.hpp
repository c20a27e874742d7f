#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echoway::text {

/// One word of a line of a building file.
struct Token {
  std::string text;  ///< Without quotes and escapes.
  bool quoted = false;
};

/// The words of a line: separated by blanks, up to a `#` outside quotes. `"..."` is one word; inside it `\"` is a quote
/// and `\\` a backslash. Nothing when a quote is not closed.
[[nodiscard]] std::optional<std::vector<Token>> split_tokens(std::string_view line);

/// `name` in quotes, so that split_tokens() gives it back.
[[nodiscard]] std::string quote(std::string_view name);

[[nodiscard]] std::string_view trim(std::string_view s) noexcept;

}  // namespace echoway::text
