#include <jni.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "echoway/building/loader.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/session.hpp"
#include "echoway/speech/speaker.hpp"
#include "jni_text.hpp"
#include "layouts.hpp"
#include "session_table.hpp"

// The native methods of org.echoway.core.NativeCore. Each checks its handle and its buffers, calls the core, and writes
// what comes back into the caller's direct buffer. Nothing is kept between calls but the table of sessions.

namespace {

using echoway::Session;
using echoway::Start;
using echoway::jni::session_table;

/// What the calls return besides counts; NativeCore.kt has the same numbers.
constexpr jint kBadHandle = -1;
constexpr jint kBadBuffer = -2;
constexpr jint kFailed = -3;

std::span<std::byte> direct(JNIEnv* env, jobject buffer) {
  void* address = buffer == nullptr ? nullptr : env->GetDirectBufferAddress(buffer);
  if (address == nullptr) return {};
  return {static_cast<std::byte*>(address), static_cast<std::size_t>(env->GetDirectBufferCapacity(buffer))};
}

/// No C++ exception may cross into the JVM; the only one the core leaves possible is lack of memory.
template <class F>
auto guarded(F f, decltype(f()) otherwise) -> decltype(f()) {
  try {
    return f();
  } catch (...) {
    return otherwise;
  }
}

void explain(JNIEnv* env, jobjectArray error, const echoway::Error& what) {
  env->SetObjectArrayElement(error, 0, echoway::jni::to_java(env, what.to_string()));
}

/// Room by index, negative for unknown; NaN for an unknown position or heading.
Start start_from(jint room, jdouble x, jdouble y, jdouble heading) {
  Start start;
  if (room < 0) return start;
  start.room = room;
  if (!std::isnan(x) && !std::isnan(y)) start.position = echoway::Vec2{x, y};
  if (!std::isnan(heading)) start.heading = heading;
  return start;
}

/// NaN for what is as on the usual belt.
std::optional<double> known(jdouble value) { return std::isnan(value) ? std::nullopt : std::optional<double>(value); }

echoway::BeltConfig belt_from(jint sensors, jdouble radius_m, jdouble beam_rad, jdouble slot_s) {
  return echoway::BeltHeader{sensors, radius_m, known(beam_rad), known(slot_s), {}}.apply_to({});
}

/// 0, and error[0] set, when it could not be opened.
jlong handle_of(JNIEnv* env, echoway::Result<std::unique_ptr<Session>> session, jobjectArray error) {
  if (session.ok()) return session_table().add(std::move(session).value());
  explain(env, error, session.error());
  return 0;
}

/// Runs `input` on the session and writes the estimate it leaves behind. Returns what `input` does, or an error.
template <class Input>
jint feed(JNIEnv* env, jlong handle, jobject estimate_out, Input input) {
  return guarded(
      [&]() -> jint {
        const auto session = session_table().find(handle);
        if (!session) return kBadHandle;
        const auto out = direct(env, estimate_out);
        if (out.size() < echoway::jni::kEstimateBytes) return kBadBuffer;
        const jint result = input(*session);
        echoway::jni::write_estimate(session->estimate(), out);
        return result;
      },
      kFailed);
}

/// Runs `use` on the session.
template <class Use>
jint with_session(jlong handle, Use use) {
  return guarded(
      [&]() -> jint {
        const auto session = session_table().find(handle);
        return session ? use(*session) : kBadHandle;
      },
      kFailed);
}

/// Runs a wish of the wearer's that the core may refuse.
template <class Wish>
jint wish(JNIEnv* env, jlong handle, jobjectArray error, Wish ask) {
  return with_session(handle, [&](Session& session) -> jint {
    const echoway::Status status = ask(session);
    if (status.ok()) return 0;
    explain(env, error, status.error());
    return kFailed;
  });
}

bool is_style(jint language, jint direction, jint length) {
  return language >= 0 && language <= static_cast<jint>(echoway::Language::french) && direction >= 0 &&
         direction <= static_cast<jint>(echoway::DirectionStyle::degrees) && length >= 0 &&
         length <= static_cast<jint>(echoway::LengthStyle::steps);
}

}  // namespace

extern "C" {

/// Bytes that the floor plan in a folder takes in PlanLayout; written when the buffer is large enough. kFailed with
/// error[0] set when the building is unusable.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_plan(JNIEnv* env, jclass, jstring folder, jobject out,
                                                             jobjectArray error) {
  return guarded(
      [&]() -> jint {
        const auto building = echoway::load_building(echoway::jni::to_utf8(env, folder));
        if (building.ok()) return static_cast<jint>(echoway::jni::write_plan(*building, direct(env, out)));
        explain(env, error, building.error());
        return kFailed;
      },
      kFailed);
}

/// Handle of a new session, or 0 with error[0] set.
JNIEXPORT jlong JNICALL Java_org_echoway_core_NativeCore_open(JNIEnv* env, jclass, jstring folder, jint sensors,
                                                              jdouble radius_m, jdouble beam_rad, jdouble slot_s,
                                                              jdouble temperature_c, jint room, jdouble x, jdouble y,
                                                              jdouble heading, jlong seed, jobjectArray error) {
  return guarded(
      [&]() -> jlong {
        echoway::SessionConfig config;
        config.belt = belt_from(sensors, radius_m, beam_rad, slot_s);
        config.air_c = known(temperature_c);
        config.start = start_from(room, x, y, heading);
        config.seed = static_cast<std::uint64_t>(seed);
        return handle_of(env, Session::open(std::filesystem::path(echoway::jni::to_utf8(env, folder)), config), error);
      },
      0);
}

/// Handle of a new session in the building that an open one has loaded, or 0 with error[0] set (no error for a stale
/// handle). The old session stays open.
JNIEXPORT jlong JNICALL Java_org_echoway_core_NativeCore_withBelt(JNIEnv* env, jclass, jlong handle, jint sensors,
                                                                  jdouble radius_m, jdouble beam_rad, jdouble slot_s,
                                                                  jint room, jdouble x, jdouble y, jdouble heading,
                                                                  jobjectArray error) {
  return guarded(
      [&]() -> jlong {
        const auto session = session_table().find(handle);
        if (!session) return 0;
        echoway::SessionConfig config = session->config();
        config.belt = belt_from(sensors, radius_m, beam_rad, slot_s);
        config.start = start_from(room, x, y, heading);
        return handle_of(env, Session::open(session->building(), config), error);
      },
      0);
}

JNIEXPORT void JNICALL Java_org_echoway_core_NativeCore_close(JNIEnv*, jclass, jlong handle) {
  session_table().remove(handle);
}

/// The first `length` bytes of `bytes` arrived. Returns the firings they completed.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_onBytes(JNIEnv* env, jclass, jlong handle, jobject bytes,
                                                                jint length, jdouble arrival_s, jobject estimate_out) {
  const auto in = direct(env, bytes);
  if (length < 0 || static_cast<std::size_t>(length) > in.size()) return kBadBuffer;
  const std::span<const std::uint8_t> arrived{reinterpret_cast<const std::uint8_t*>(in.data()),
                                              static_cast<std::size_t>(length)};
  return feed(env, handle, estimate_out, [&](Session& session) { return session.on_bytes(arrived, arrival_s); });
}

/// `kind`: see echoway::MotionKind.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_onMotion(JNIEnv* env, jclass, jlong handle, jint kind,
                                                                 jdouble value, jdouble time_s, jobject estimate_out) {
  if (kind < 0 || kind > static_cast<jint>(echoway::MotionKind::heading)) return kFailed;
  const echoway::MotionHint hint{time_s, static_cast<echoway::MotionKind>(kind), value};
  return feed(env, handle, estimate_out, [&](Session& session) {
    session.on_motion(hint);
    return 0;
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_onTick(JNIEnv* env, jclass, jlong handle, jdouble now_s,
                                                               jobject estimate_out) {
  return feed(env, handle, estimate_out, [&](Session& session) {
    session.on_tick(now_s);
    return 0;
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_onBelt(JNIEnv* env, jclass, jlong handle, jboolean attached,
                                                               jdouble now_s, jobject estimate_out) {
  return feed(env, handle, estimate_out, [&](Session& session) {
    attached ? session.on_belt_attached(now_s) : session.on_belt_detached(now_s);
    return 0;
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_restart(JNIEnv* env, jclass, jlong handle, jint room, jdouble x,
                                                                jdouble y, jdouble heading, jobject estimate_out,
                                                                jobjectArray error) {
  return feed(env, handle, estimate_out, [&](Session& session) {
    const auto status = session.restart(start_from(room, x, y, heading));
    if (status.ok()) return 0;
    explain(env, error, status.error());
    return kFailed;
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_beltHealth(JNIEnv* env, jclass, jlong handle, jobject out) {
  return guarded(
      [&]() -> jint {
        const auto session = session_table().find(handle);
        if (!session) return kBadHandle;
        const auto buffer = direct(env, out);
        if (buffer.size() < echoway::jni::kBeltHealthBytes) return kBadBuffer;
        return static_cast<jint>(echoway::jni::write_belt_health(session->belt_health(), buffer));
      },
      kFailed);
}

/// Everything that is wrong with the floor plan in a folder: bytes that it takes, written when the buffer is large
/// enough.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_check(JNIEnv* env, jclass, jstring folder, jobject out) {
  return guarded(
      [&]() -> jint {
        const auto findings = echoway::check_building(echoway::jni::to_utf8(env, folder));
        return static_cast<jint>(echoway::jni::write_findings(findings, direct(env, out)));
      },
      kFailed);
}

/// The next cue with its words. Bytes written, or 0 when there is none. `language`, `direction` and `length` are
/// ordinals of echoway::Language, DirectionStyle and LengthStyle.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_nextCue(JNIEnv* env, jclass, jlong handle, jint language,
                                                                jint direction, jint length, jobject out) {
  if (!is_style(language, direction, length)) return kFailed;
  return with_session(handle, [&](Session& session) -> jint {
    const auto buffer = direct(env, out);
    if (buffer.size() < echoway::jni::kCueFixedBytes) return kBadBuffer;
    echoway::Cue cue;
    if (!session.next_cue(cue)) return 0;
    const echoway::SpeechStyle style{static_cast<echoway::Language>(language),
                                     static_cast<echoway::DirectionStyle>(direction),
                                     static_cast<echoway::LengthStyle>(length)};
    const std::string words = echoway::Speaker(session.building(), style).say(cue);
    return static_cast<jint>(echoway::jni::write_cue(cue, words, buffer));
  });
}

/// `kind` and `index`: see echoway::Goal; a spot is none of them. The way to the nearest exit is kind 3.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_setDestination(JNIEnv* env, jclass, jlong handle, jint kind,
                                                                       jint index, jboolean avoid_stairs,
                                                                       jobjectArray error) {
  if (kind < static_cast<jint>(echoway::Goal::Kind::place) || kind > static_cast<jint>(echoway::Goal::Kind::room)) {
    return kFailed;
  }
  const echoway::Goal goal{static_cast<echoway::Goal::Kind>(kind), index, {}};
  const echoway::RoutePreferences preferences{avoid_stairs == JNI_TRUE};
  return wish(env, handle, error, [&](Session& session) { return session.set_destination(goal, preferences); });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_backTrack(JNIEnv* env, jclass, jlong handle,
                                                                  jobjectArray error) {
  return wish(env, handle, error, [](Session& session) { return session.back_track(); });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_clearDestination(JNIEnv*, jclass, jlong handle) {
  return with_session(handle, [](Session& session) {
    session.clear_destination();
    return 0;
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_whereAmI(JNIEnv*, jclass, jlong handle) {
  return with_session(handle, [](Session& session) {
    session.where_am_i();
    return 0;
  });
}

/// 1 when there is something to repeat, else 0.
JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_repeat(JNIEnv*, jclass, jlong handle) {
  return with_session(handle, [](Session& session) { return session.repeat() ? 1 : 0; });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_hasDestination(JNIEnv*, jclass, jlong handle) {
  return with_session(handle, [](Session& session) { return session.has_destination() ? 1 : 0; });
}

/// Metres; negative when nothing is in the way or the handle is stale.
JNIEXPORT jdouble JNICALL Java_org_echoway_core_NativeCore_obstacleAhead(JNIEnv*, jclass, jlong handle) {
  return guarded(
      [&]() -> jdouble {
        const auto session = session_table().find(handle);
        return session ? session->obstacle_ahead_m() : -1.0;
      },
      -1.0);
}

// What a picture of the session needs: bytes that it takes, written when the buffer is large enough.

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_route(JNIEnv* env, jclass, jlong handle, jobject out) {
  return with_session(handle, [&](Session& session) {
    return static_cast<jint>(echoway::jni::write_route(session.route(), direct(env, out)));
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_breadcrumbs(JNIEnv* env, jclass, jlong handle, jobject out) {
  return with_session(handle, [&](Session& session) {
    return static_cast<jint>(echoway::jni::write_spots(session.breadcrumbs(), direct(env, out)));
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_hypotheses(JNIEnv* env, jclass, jlong handle, jobject out) {
  return with_session(handle, [&](Session& session) {
    return static_cast<jint>(echoway::jni::write_hypotheses(session.hypotheses(), direct(env, out)));
  });
}

JNIEXPORT jint JNICALL Java_org_echoway_core_NativeCore_scan(JNIEnv* env, jclass, jlong handle, jobject out) {
  return with_session(handle, [&](Session& session) {
    return static_cast<jint>(echoway::jni::write_echoes(session.explain_scan(), direct(env, out)));
  });
}

}  // extern "C"
