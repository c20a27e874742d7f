#include "text/format.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace echoway::text {
namespace {

constexpr std::array<double, 7> kPowersOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

void append_integer(std::string& out, std::uint64_t value) {
  std::array<char, 24> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), result.ptr);
}

}  // namespace

bool is_writable(double value) noexcept { return std::abs(value) < kMaxWritable; }

// Not printf(): its decimal point follows the process's locale.
void append_number(std::string& out, double value, int decimals) {
  if (!is_writable(value)) value = 0.0;
  const double scale = kPowersOfTen[static_cast<std::size_t>(decimals)];
  const auto scaled = static_cast<std::uint64_t>(std::llround(std::abs(value) * scale));
  const auto unit = static_cast<std::uint64_t>(scale);
  if (value < 0.0 && scaled > 0) out += '-';
  append_integer(out, scaled / unit);
  std::uint64_t fraction = scaled % unit;
  if (fraction == 0) return;
  std::string digits(static_cast<std::size_t>(decimals), '0');
  for (std::size_t i = digits.size(); i-- > 0; fraction /= 10) digits[i] = static_cast<char>('0' + fraction % 10);
  digits.erase(digits.find_last_not_of('0') + 1);
  out += '.';
  out += digits;
}

std::string brief(double value) {
  if (!is_writable(value)) return value < 0.0 ? "less than -1e12" : "more than 1e12";
  std::string out;
  append_number(out, value, 2);
  return out;
}

}  // namespace echoway::text
