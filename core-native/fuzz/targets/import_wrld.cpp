#include "folder_in_one_piece.hpp"
#include "import_promises.hpp"
#include "target.hpp"

namespace echoway::fuzz {

std::string import_wrld(Bytes data) {
  const plans::ScratchFolder folder("fuzz-import-wrld");
  unpack(data, folder);
  return check_import(import::SourceFormat::wrld, folder.path());
}

}  // namespace echoway::fuzz
