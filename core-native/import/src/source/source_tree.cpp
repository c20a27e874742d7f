#include "source/source_tree.hpp"

#include <zip.h>

#include <fstream>

#include "source/limits.hpp"
#include "source/source_error.hpp"

namespace echoway::import {

namespace fs = std::filesystem;

struct SourceTree::Archive {
  zip_t* zip = nullptr;
  ~Archive() { zip_discard(zip); }
};

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& what) { throw SourceError(Error{what, file, 0}); }

[[noreturn]] void refuse_size(const std::string& file) {
  refuse(file, "is larger than " + std::to_string(kMaxFileBytes >> 20) + " MiB unpacked, which no floor plan is");
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) refuse(path.string(), "is not a file that can be read");
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(path.string(), "cannot be opened");
  std::string text;
  std::string block(1u << 16, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMaxFileBytes) refuse_size(path.string());
  }
  return text;
}

SourceTree::SourceTree(const fs::path& path) : path_(path) {
  std::error_code error;
  if (fs::is_directory(path_, error)) {
    open_folder();
  } else if (fs::is_regular_file(path_, error) && path_.filename() == "main.json") {
    path_ = path_.parent_path();
    open_folder();
  } else if (fs::is_regular_file(path_, error)) {
    open_archive();
  } else {
    refuse(path_.string(), "no such folder or zip archive");
  }
}

SourceTree::~SourceTree() = default;

void SourceTree::open_folder() {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_.empty() ? "." : path_, error)) {
    if (!entry.is_regular_file(error)) continue;
    entries_.emplace(entry.path().filename().string(), entry.path().string());
    if (entries_.size() > kMaxArchiveEntries) refuse(path_.string(), "holds too many files to be a floor plan");
  }
  if (error) refuse(path_.string(), "cannot be listed: " + error.message());
}

void SourceTree::open_archive() {
  int code = 0;
  archive_ = std::make_unique<Archive>();
  archive_->zip = zip_open(path_.c_str(), ZIP_RDONLY, &code);
  if (archive_->zip == nullptr) {
    archive_.reset();
    refuse(path_.string(), "is neither a folder nor a zip archive that can be read");
  }
  const zip_int64_t count = zip_get_num_entries(archive_->zip, 0);
  if (count < 0 || static_cast<std::size_t>(count) > kMaxArchiveEntries) {
    refuse(path_.string(), "holds too many files to be a floor plan");
  }
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive_->zip, static_cast<zip_uint64_t>(i), 0);
    if (name == nullptr) continue;
    const std::string base = fs::path(name).filename().string();
    // macOS adds shadow files that begin with a dot and share the real files' extension.
    if (!base.empty() && base.front() != '.') entries_.emplace(base, std::to_string(i));
  }
}

std::string SourceTree::label(const std::string& name) const {
  return archive_ ? path_.string() + "/" + name : (path_ / name).string();
}

std::string SourceTree::read(const std::string& name) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) refuse(label(name), "is missing");
  std::string text = archive_ ? read_entry(name) : read_file(found->second);
  bytes_read_ += text.size();
  if (bytes_read_ > kMaxArchiveBytes) refuse(path_.string(), "unpacks to more than a floor plan can hold");
  return text;
}

std::string SourceTree::read_entry(const std::string& name) {
  const auto index = static_cast<zip_uint64_t>(std::stoull(entries_.at(name)));
  zip_file_t* file = zip_fopen_index(archive_->zip, index, 0);
  if (file == nullptr) refuse(label(name), std::string("cannot be unpacked: ") + zip_strerror(archive_->zip));
  // The size that an archive claims is not trusted: what comes out is counted.
  std::string text;
  std::string block(1u << 16, '\0');
  zip_int64_t got = 0;
  while ((got = zip_fread(file, block.data(), block.size())) > 0 && text.size() <= kMaxFileBytes) {
    text.append(block.data(), static_cast<std::size_t>(got));
  }
  const bool damaged = got < 0;
  zip_fclose(file);
  if (damaged) refuse(label(name), "is damaged in the archive");
  if (text.size() > kMaxFileBytes) refuse_size(label(name));
  return text;
}

}  // namespace echoway::import
