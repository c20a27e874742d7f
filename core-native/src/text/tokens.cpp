#include "echoway/text/tokens.hpp"

namespace echoway::text {
namespace {

bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

/// Reads a quoted word that starts at `i`; leaves `i` behind its closing quote. False when there is none.
bool read_quoted(std::string_view line, std::size_t& i, std::string& out) {
  for (++i; i < line.size(); ++i) {
    if (line[i] == '"') {
      ++i;
      return true;
    }
    const bool escaped = line[i] == '\\' && i + 1 < line.size() && (line[i + 1] == '"' || line[i + 1] == '\\');
    if (escaped) ++i;
    out += line[i];
  }
  return false;
}

}  // namespace

std::optional<std::vector<Token>> split_tokens(std::string_view line) {
  std::vector<Token> tokens;
  std::size_t i = 0;
  while (true) {
    while (i < line.size() && is_blank(line[i])) ++i;
    if (i == line.size() || line[i] == '#') return tokens;
    Token& token = tokens.emplace_back();
    if (line[i] == '"') {
      token.quoted = true;
      if (!read_quoted(line, i, token.text)) return std::nullopt;
      continue;
    }
    const std::size_t start = i;
    while (i < line.size() && !is_blank(line[i]) && line[i] != '#' && line[i] != '"') ++i;
    token.text.assign(line.substr(start, i - start));
  }
}

std::string quote(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string_view trim(std::string_view s) noexcept {
  while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
  return s;
}

std::size_t split_at_commas(std::string_view line, std::span<std::string_view> fields) noexcept {
  std::size_t count = 0;
  while (true) {
    const std::size_t comma = line.find(',');
    if (count < fields.size()) fields[count] = trim(line.substr(0, comma));
    ++count;
    if (comma == std::string_view::npos) return count;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace echoway::text
