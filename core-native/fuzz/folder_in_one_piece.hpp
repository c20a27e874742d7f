#pragma once

#include "plans/scratch_folder.hpp"
#include "target.hpp"

namespace echoway::fuzz {

/// Writes the files of a folder that comes in one piece: a line `=== NAME` starts a file, the lines below it are its
/// contents. A name that would lead out of `folder` is left out.
void unpack(Bytes data, const plans::ScratchFolder& folder);

}  // namespace echoway::fuzz
