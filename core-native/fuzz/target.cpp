#include "target.hpp"

#include <array>

namespace echoway::fuzz {

std::span<const Target> targets() {
  static constexpr std::array kAll{
      Target{"building", building},       Target{"import_osm", import_osm},   Target{"import_wrld", import_wrld},
      Target{"import_imdf", import_imdf}, Target{"sentences", sentences},     Target{"scan_log", scan_log},
      Target{"motion_log", motion_log},   Target{"track_log", track_log},     Target{"session", session},
      Target{"tracker", tracker},         Target{"guidance", guidance},       Target{"jni_layouts", jni_layouts},
      Target{"thesis", thesis},           Target{"belt", belt},               Target{"import_drawn", import_drawn},
#ifdef ECHOWAY_JNI_HEADERS
      Target{"jni_calls", jni_calls},
#endif
  };
  return kAll;
}

}  // namespace echoway::fuzz
