#pragma once

#include <cstddef>
#include <optional>
#include <span>
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

/// Splits `line` at commas into `fields`, each trimmed; the number of fields that it has, which may be more than fit.
[[nodiscard]] std::size_t split_at_commas(std::string_view line, std::span<std::string_view> fields) noexcept;

}  // namespace echoway::text
