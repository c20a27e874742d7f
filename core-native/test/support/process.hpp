#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace echoway::test {

struct ProcessResult {
  int status = -1;  ///< Exit status; -1 when a signal ended it.
  std::string out;
  std::string err;
};

/// Files that take a process's output instead; blank: it is caught.
struct Redirection {
  std::filesystem::path out = {};
  std::filesystem::path err = {};
};

/// Runs the command line tool with `arguments` and waits for it.
ProcessResult run_echoway(const std::vector<std::string>& arguments, const Redirection& redirection = {});

/// The command line tool running in the background; killed, if need be, when it goes out of scope.
class BackgroundEchoway {
 public:
  explicit BackgroundEchoway(const std::vector<std::string>& arguments);
  BackgroundEchoway(const BackgroundEchoway&) = delete;
  BackgroundEchoway& operator=(const BackgroundEchoway&) = delete;
  ~BackgroundEchoway();

  /// The next line of its standard output, without the newline; empty at its end.
  std::string read_line();

 private:
  int process_ = -1;
  int out_ = -1;
};

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes `text` to the file `name` in the folder and gives its path.
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& file);

}  // namespace echoway::test
