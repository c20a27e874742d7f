#include "echoway/text/number.hpp"

#include <locale.h>

#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace echoway::text {
namespace {

/// Longer tokens are no measurement of anything; the limit keeps the copy below on the stack.
constexpr std::size_t kMaxNumberLength = 63;

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

std::size_t skip_digits(std::string_view s, std::size_t i) noexcept {
  while (i < s.size() && is_digit(s[i])) ++i;
  return i;
}

std::size_t skip_sign(std::string_view s, std::size_t i) noexcept {
  return i < s.size() && (s[i] == '+' || s[i] == '-') ? i + 1 : i;
}

/// strtod() takes more than a decimal number (hexadecimal, nan, inf, leading blanks): the grammar is checked first.
bool is_decimal(std::string_view s) noexcept {
  const std::size_t start = skip_sign(s, 0);
  std::size_t i = skip_digits(s, start);
  std::size_t digits = i - start;
  if (i < s.size() && s[i] == '.') {
    const std::size_t fraction = skip_digits(s, i + 1);
    digits += fraction - (i + 1);
    i = fraction;
  }
  if (digits == 0) return false;
  if (i < s.size() && (s[i] == 'e' || s[i] == 'E')) {
    const std::size_t exponent = skip_sign(s, i + 1);
    i = skip_digits(s, exponent);
    if (i == exponent) return false;
  }
  return i == s.size();
}

/// A decimal point is a point in our files, also in a process whose locale writes a comma.
locale_t c_locale() noexcept {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", static_cast<locale_t>(nullptr));
  return locale;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) noexcept {
  if (token.size() > kMaxNumberLength || !is_decimal(token)) return std::nullopt;
  std::array<char, kMaxNumberLength + 1> buffer{};
  std::memcpy(buffer.data(), token.data(), token.size());
  const double value = strtod_l(buffer.data(), nullptr, c_locale());
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long long> parse_integer(std::string_view token) noexcept {
  const std::size_t digits = skip_sign(token, 0);
  if (digits == token.size() || !is_digit(token[digits])) return std::nullopt;
  if (token.front() == '+') token.remove_prefix(1);  // from_chars() knows no plus
  long long value = 0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace echoway::text
