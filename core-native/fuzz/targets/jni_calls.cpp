// The native methods as Kotlin calls them, in any order and with anything that Kotlin could hand over: stale handles,
// null and short buffers, heap buffers, numbers out of range, strings with lone surrogates.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "echoway/belt/sentence.hpp"
#include "echoway/building/writer.hpp"
#include "java_env.hpp"
#include "layouts.hpp"
#include "plans/plans.hpp"
#include "plans/scratch_folder.hpp"
#include "reader.hpp"
#include "target.hpp"
#include "wishes.hpp"

extern "C" {
#define NATIVE(type, name) JNIEXPORT type JNICALL Java_org_echoway_core_NativeCore_##name
NATIVE(jint, plan)(JNIEnv*, jclass, jstring, jobject, jobjectArray);
NATIVE(jint, check)(JNIEnv*, jclass, jstring, jobject);
NATIVE(jlong, open)(JNIEnv*, jclass, jstring, jint, jdouble, jdouble, jdouble, jdouble, jint, jdouble, jdouble, jdouble,
                    jlong, jobjectArray);
NATIVE(jlong, withBelt)(JNIEnv*, jclass, jlong, jint, jdouble, jdouble, jdouble, jint, jdouble, jdouble, jdouble,
                        jobjectArray);
NATIVE(void, close)(JNIEnv*, jclass, jlong);
NATIVE(jint, onBytes)(JNIEnv*, jclass, jlong, jobject, jint, jdouble, jobject);
NATIVE(jint, onMotion)(JNIEnv*, jclass, jlong, jint, jdouble, jdouble, jobject);
NATIVE(jint, onTick)(JNIEnv*, jclass, jlong, jdouble, jobject);
NATIVE(jint, onBelt)(JNIEnv*, jclass, jlong, jboolean, jdouble, jobject);
NATIVE(jint, restart)(JNIEnv*, jclass, jlong, jint, jdouble, jdouble, jdouble, jobject, jobjectArray);
NATIVE(jint, beltHealth)(JNIEnv*, jclass, jlong, jobject);
NATIVE(jint, nextCue)(JNIEnv*, jclass, jlong, jint, jint, jint, jobject);
NATIVE(jint, setDestination)(JNIEnv*, jclass, jlong, jint, jint, jboolean, jobjectArray);
NATIVE(jint, backTrack)(JNIEnv*, jclass, jlong, jobjectArray);
NATIVE(jint, clearDestination)(JNIEnv*, jclass, jlong);
NATIVE(jint, whereAmI)(JNIEnv*, jclass, jlong);
NATIVE(jint, repeat)(JNIEnv*, jclass, jlong);
NATIVE(jint, hasDestination)(JNIEnv*, jclass, jlong);
NATIVE(jdouble, obstacleAhead)(JNIEnv*, jclass, jlong);
NATIVE(jint, route)(JNIEnv*, jclass, jlong, jobject);
NATIVE(jint, breadcrumbs)(JNIEnv*, jclass, jlong, jobject);
NATIVE(jint, hypotheses)(JNIEnv*, jclass, jlong, jobject);
NATIVE(jint, scan)(JNIEnv*, jclass, jlong, jobject);
#undef NATIVE
}

#define CALL(name, ...) Java_org_echoway_core_NativeCore_##name(env, nullptr __VA_OPT__(, ) __VA_ARGS__)

namespace echoway::fuzz {
namespace {

constexpr int kMostCalls = 120;
constexpr int kMostFirings = 10;
constexpr int kMostOpened = 2;  ///< Sessions and restarts: each makes a tracker.
constexpr jint kLongestRead = 2048;
constexpr jint kLeastCode = -3;
constexpr int kNumbersOfEstimate = 12;

/// The building that all sessions are opened in; one folder for the whole run.
const std::filesystem::path& folder() {
  static const plans::ScratchFolder scratch("fuzz-jni");
  static const Status written = write_building(plans::guided_closets(), scratch.path());
  static_cast<void>(written);
  return scratch.path();
}

class Caller {
 public:
  explicit Caller(Reader& in) : in_(in) {}
  ~Caller() {
    for (const jlong handle : handles_) CALL(close, handle);
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  // What is read off the input is read into variables first: the compilers disagree on the order of a call's arguments.

  /// Returns which promise was broken.
  std::string call() {
    const std::uint8_t what = in_.byte();
    const double time = clock_.next(in_);
    const jlong to = handle();
    switch (what % 24) {
      case 0: return open();
      case 1: return close(to);
      case 2: return plan();
      case 3: return go(to, what > 127);
      case 4: return refusable([&](jobjectArray e) { return CALL(backTrack, to, e); });
      case 5: return plain(CALL(clearDestination, to));
      case 6: return plain(CALL(whereAmI, to));
      case 7: return plain(CALL(repeat, to));
      case 8: return plain(CALL(hasDestination, to));
      case 9: return std::isfinite(CALL(obstacleAhead, to)) ? "" : "an obstacle at no distance";
      case 10: return plain(CALL(route, to, buffer()));
      case 11: return plain(CALL(breadcrumbs, to, buffer()));
      case 12: return plain(CALL(hypotheses, to, buffer()));
      case 13: return plain(CALL(scan, to, buffer()));
      case 14: return plain(CALL(beltHealth, to, buffer()));
      case 15: return cue(to);
      case 16: return fed([&](jobject out) { return CALL(onTick, to, time, out); });
      case 17: return belt(to, time);
      case 18: return motion(to, time);
      case 19: return restart(to);
      case 20: return with_other_belt(to);
      default: return bytes(to, time);
    }
  }

 private:
  /// Mostly the newest; sometimes one that was closed or never given out.
  jlong handle() {
    const std::uint8_t what = in_.byte();
    if (what < 8) return in_.integer();
    return handles_.empty() ? 0 : handles_[what % 8 == 1 ? what % handles_.size() : handles_.size() - 1];
  }

  /// Mostly large enough.
  jobject buffer() {
    const std::uint8_t what = in_.byte();
    if (what < 4) return nullptr;
    if (what < 8) return java_.heap_buffer();
    return java_.buffer(what < 32 ? in_.word() % 2048 : 4096);
  }

  std::u16string any_text() {
    std::u16string text(in_.byte() % 24, u'\0');
    for (char16_t& unit : text) unit = static_cast<char16_t>(in_.byte() < 128 ? in_.byte() : in_.word());
    return text;
  }

  /// The building's folder, or one below it that is not there: a path may lead nowhere else.
  jstring path() {
    const std::u16string base = folder().u16string();
    const std::uint8_t what = in_.byte();
    if (what < 240) return java_.string(base);
    return what == 255 ? nullptr : java_.string(base + u"/" + any_text());
  }

  /// An error must be told in Java's UTF-16.
  std::string told(jobjectArray error) const {
    const std::u16string* words = JavaEnv::first(error);
    if (words == nullptr || words->empty()) return "an error without words";
    for (std::size_t i = 0; i < words->size(); ++i) {
      const bool high = ((*words)[i] & 0xFC00) == 0xD800;
      const bool low = ((*words)[i] & 0xFC00) == 0xDC00;
      if (low || (high && (i + 1 == words->size() || ((*words)[i + 1] & 0xFC00) != 0xDC00))) {
        return "an error with half a character";
      }
      i += high;
    }
    return "";
  }

  std::string plain(jint code) const { return code >= kLeastCode ? "" : "no such code"; }

  template <class Wish>
  std::string refusable(Wish wish) {
    const jobjectArray error = java_.array(1);
    const jint code = wish(error);
    // Out of range is refused without words: Kotlin never asks for it.
    return JavaEnv::first(error) != nullptr ? told(error) : plain(code);
  }

  template <class Input>
  std::string fed(Input input) {
    const jobject out = buffer();
    const jint code = input(out);
    if (code < 0) return plain(code);
    std::array<double, kNumbersOfEstimate> numbers{};
    std::memcpy(numbers.data(), JavaEnv::bytes(out), sizeof numbers);
    const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
    return finite ? "" : "an estimate that is not finite";
  }

  std::string open() {
    if (opened_++ >= kMostOpened) return "";
    const jobjectArray error = java_.array(1);
    const jint sensors = in_.byte() < 16 ? in_.integer() : 15;
    const double radius = in_.byte() < 16 ? in_.number() : 0.15;
    const jint room = in_.byte() < 224 ? in_.byte() % 2 : in_.integer();
    const jstring where = path();
    const Vec2 at = in_.byte() < 224 ? in_.spot() : Vec2{in_.number(), in_.number()};
    const double heading = in_.number();
    const std::uint64_t seed = in_.word();
    // Last, so that older inputs still mean what they did.
    const double usual = std::numeric_limits<double>::quiet_NaN();
    const bool other_belt = in_.byte() % 16 == 1;
    const double beam = other_belt ? in_.number() : usual;
    const double slot = other_belt ? in_.number() : usual;
    const double temperature = other_belt ? in_.number() : usual;
    const jlong handle = CALL(open, where, sensors, radius, beam, slot, temperature, room, at.x, at.y, heading,
                              static_cast<jlong>(seed), error);
    if (handle == 0) return told(error);
    handles_.push_back(handle);
    return "";
  }

  std::string with_other_belt(jlong to) {
    if (opened_++ >= kMostOpened) return "";
    const jobjectArray error = java_.array(1);
    const jint sensors = in_.byte() < 192 ? 1 + in_.byte() % 16 : in_.integer();
    const double radius = in_.byte() < 192 ? 0.15 : in_.number();
    const double beam = in_.number();
    const double slot = in_.number();
    const jint room = in_.byte() % 4 - 1;
    const Vec2 at = in_.spot();
    const double heading = in_.number();
    const jlong handle = CALL(withBelt, to, sensors, radius, beam, slot, room, at.x, at.y, heading, error);
    if (handle != 0) handles_.push_back(handle);
    // A stale handle is refused without words: Kotlin holds none.
    return handle != 0 || JavaEnv::first(error) == nullptr ? "" : told(error);
  }

  std::string close(jlong handle) {
    CALL(close, handle);
    return "";
  }

  std::string plan() {
    if (plans_++ > 0) return "";
    const jobjectArray error = java_.array(1);
    const jstring where = path();
    const jint code = CALL(plan, where, buffer(), error);
    if (code < 0) return told(error);
    return plain(CALL(check, where, buffer()));
  }

  std::string go(jlong to, bool avoid_stairs) {
    const jint kind = in_.byte() % 8 - 2;
    const jint index = in_.byte() < 16 ? in_.integer() : in_.byte() % 4 - 1;
    return refusable([&](jobjectArray error) { return CALL(setDestination, to, kind, index, avoid_stairs, error); });
  }

  std::string belt(jlong to, double time) {
    const jboolean attached = in_.byte() % 2;
    return fed([&](jobject out) { return CALL(onBelt, to, attached, time, out); });
  }

  std::string motion(jlong to, double time) {
    const jint kind = in_.byte() % 6 - 1;
    const double value = in_.number();
    return fed([&](jobject out) { return CALL(onMotion, to, kind, value, time, out); });
  }

  std::string restart(jlong to) {
    if (opened_++ >= kMostOpened) return "";
    const jobjectArray error = java_.array(1);
    const jint room = in_.byte() % 4 - 1;
    const Vec2 at{in_.number(), in_.number()};
    const double heading = in_.number();
    return fed([&](jobject out) { return CALL(restart, to, room, at.x, at.y, heading, out, error); });
  }

  std::string cue(jlong to) {
    const std::uint8_t style = in_.byte();
    return plain(CALL(nextCue, to, style % 5 - 1, style / 5 % 5 - 1, style / 25 % 5 - 1, buffer()));
  }

  std::string bytes(jlong to, double time) {
    const jobject sent = buffer();
    const std::uint8_t how = in_.byte();
    jint length = 0;
    if (sent != nullptr && JavaEnv::bytes(sent) != nullptr && how >= 16 && firings_ < kMostFirings) {
      length = fill(sent, how);
    } else if (how < 8) {
      length = std::min<jint>(in_.integer(), kLongestRead);
    }
    return fed([&](jobject out) {
      const jint taken = CALL(onBytes, to, sent, length, time, out);
      firings_ += std::max(0, taken);
      return taken;
    });
  }

  /// A sentence of the belt's or anything; returns how many bytes. More than the buffer holds are left out.
  jint fill(jobject sent, std::uint8_t how) {
    std::string text;
    if (how < 32) {
      text = any_name(in_);
    } else {
      const EchoSentence echo{in_.byte(), static_cast<std::uint8_t>(in_.byte() % 15), 100U * in_.byte()};
      text = encode(echo).text();
    }
    if (java_.get()->GetDirectBufferCapacity(sent) < static_cast<jlong>(text.size())) return 0;
    std::memcpy(JavaEnv::bytes(sent), text.data(), text.size());
    return static_cast<jint>(text.size());
  }

  Reader& in_;
  JavaEnv java_;
  JNIEnv* env = java_.get();
  std::vector<jlong> handles_;
  Clock clock_;
  int opened_ = 0;
  int plans_ = 0;
  int firings_ = 0;
};

}  // namespace

std::string jni_calls(Bytes data) {
  Reader in(data);
  Caller caller(in);
  for (int i = 0; i < kMostCalls && !in.empty(); ++i) {
    if (std::string broken = caller.call(); !broken.empty()) return broken;
  }
  return "";
}

}  // namespace echoway::fuzz
