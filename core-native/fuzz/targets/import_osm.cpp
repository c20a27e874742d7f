#include "import_promises.hpp"
#include "memory_file.hpp"
#include "target.hpp"

namespace echoway::fuzz {

/// The input is an OpenStreetMap file.
std::string import_osm(Bytes data) { return check_import(import::SourceFormat::osm, MemoryFile(data).path()); }

}  // namespace echoway::fuzz
