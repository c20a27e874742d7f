#pragma once

#include <jni.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace echoway::fuzz {

/// As much of a Java virtual machine as the JNI library asks for: strings, direct buffers and arrays of objects.
/// Everything is the environment's and lives as long as it does.
class JavaEnv {
 public:
  JavaEnv();
  ~JavaEnv();
  JavaEnv(const JavaEnv&) = delete;
  JavaEnv& operator=(const JavaEnv&) = delete;

  [[nodiscard]] JNIEnv* get() noexcept { return &env_; }

  [[nodiscard]] jstring string(std::u16string text);
  /// A direct ByteBuffer whose memory has exactly this size, so that the address sanitizer guards both its ends.
  [[nodiscard]] jobject buffer(std::size_t size);
  /// A ByteBuffer that has no address, as one on Java's heap.
  [[nodiscard]] jobject heap_buffer();
  [[nodiscard]] jobjectArray array(std::size_t size);

  [[nodiscard]] static std::byte* bytes(jobject buffer);
  /// The string in an array's first place; null when there is none.
  [[nodiscard]] static const std::u16string* first(jobjectArray array);

 private:
  struct Object;
  Object* keep(std::unique_ptr<Object> object);
  static JavaEnv& of(JNIEnv* env);
  static Object& object(jobject reference);

  JNINativeInterface_ functions_{};  ///< A call of any other function ends the process.
  JNIEnv env_{};
  std::vector<std::unique_ptr<Object>> objects_;
};

}  // namespace echoway::fuzz
