#include "folder_in_one_piece.hpp"
#include "import_promises.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {

/// The input is a zip archive, which begins with a `P`, or else a folder in one piece.
std::string import_imdf(Bytes data) {
  if (!data.empty() && data.front() == 'P') return check_import(import::SourceFormat::imdf, MemoryFile(data).path());
  const plans::ScratchFolder folder("fuzz-import-imdf");
  unpack(data, folder);
  return check_import(import::SourceFormat::imdf, folder.path());
}

}  // namespace echoway::fuzz
