#include "support/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace echoway::test {
namespace {

int spawn(const std::vector<std::string>& arguments, int out, int err) {
  std::vector<std::string> words{ECHOWAY_CLI};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int process = fork();
  if (process == 0) {
    dup2(out, STDOUT_FILENO);
    if (err >= 0) dup2(err, STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  return process;
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "echoway-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

ProcessResult run_echoway(const std::vector<std::string>& arguments, const Redirection& redirection) {
  const TemporaryFolder folder;
  const std::filesystem::path out_file = redirection.out.empty() ? folder.path() / "out" : redirection.out;
  const std::filesystem::path err_file = redirection.err.empty() ? folder.path() / "err" : redirection.err;
  const int out = open(out_file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int err = open(err_file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int process = spawn(arguments, out, err);
  int status = 0;
  waitpid(process, &status, 0);
  close(out);
  close(err);
  const auto caught = [](const std::filesystem::path& elsewhere, const std::filesystem::path& file) {
    return elsewhere.empty() ? read_file(file) : std::string();
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, caught(redirection.out, out_file),
          caught(redirection.err, err_file)};
}

BackgroundEchoway::BackgroundEchoway(const std::vector<std::string>& arguments) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  process_ = spawn(arguments, ends[1], -1);
  close(ends[1]);
  out_ = ends[0];
}

BackgroundEchoway::~BackgroundEchoway() {
  if (out_ >= 0) close(out_);
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

std::string BackgroundEchoway::read_line() {
  std::string line;
  char c = 0;
  while (read(out_, &c, 1) == 1 && c != '\n') line += c;
  return line;
}

}  // namespace echoway::test
