#include "option_checks.hpp"

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <string>

#include "echoway/text/number.hpp"

namespace echoway::tools {
namespace {

std::optional<std::uint64_t> parse_whole(const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace

CLI::Validator decimal(double low, double high) {
  const auto check = [=](const std::string& text) {
    const std::optional<double> value = text::parse_number(text);
    if (value && *value >= low && *value <= high) return std::string();
    return fmt::format("'{}' is no number from {} to {}", text, low, high);
  };
  return {check, fmt::format("in [{} - {}]", low, high)};
}

CLI::Validator whole(std::uint64_t low, std::uint64_t high) {
  const auto check = [=](const std::string& text) {
    const std::optional<std::uint64_t> value = parse_whole(text);
    if (value && *value >= low && *value <= high) return std::string();
    return fmt::format("'{}' is no whole number from {} to {}", text, low, high);
  };
  return {check, high == UINT64_MAX ? "" : fmt::format("in [{} - {}]", low, high)};
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return std::string(text.empty() ? "is empty" : ""); }, ""};
}

}  // namespace echoway::tools
