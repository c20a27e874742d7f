#include "drawn_plans.hpp"
#include "import_promises.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {

/// The input says in which format a plan is drawn and what is in it.
std::string import_drawn(Bytes data) {
  using import::SourceFormat;
  Reader in(data);
  const std::uint8_t format = in.byte() % 3;
  if (format == 0) {
    const std::string text = draw_osm(in);
    const MemoryFile file({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return check_import(SourceFormat::osm, file.path());
  }
  const plans::ScratchFolder folder("fuzz-import-drawn");
  (format == 1 ? draw_wrld : draw_imdf)(in, folder);
  return check_import(format == 1 ? SourceFormat::wrld : SourceFormat::imdf, folder.path());
}

}  // namespace echoway::fuzz
