#include "folder_in_one_piece.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace echoway::fuzz {

void unpack(Bytes data, const plans::ScratchFolder& folder) {
  std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
  constexpr std::string_view kMark = "=== ";
  std::string name;
  std::string contents;
  const auto finish = [&] {
    const bool usable = !name.empty() && name.size() < 64 && name.find('/') == std::string::npos &&
                        name.find('\0') == std::string::npos && name != "." && name != "..";
    if (usable) folder.write(name, contents);
    contents.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view line = text.substr(0, end + 1);
    text.remove_prefix(end + 1);
    if (line.starts_with(kMark)) {
      finish();
      name = std::string(line.substr(kMark.size(), line.find_last_not_of("\r\n") + 1 - kMark.size()));
    } else {
      contents += line;
    }
  }
  finish();
}

}  // namespace echoway::fuzz
