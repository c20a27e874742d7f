#include "java_env.hpp"

#include <algorithm>
#include <utility>

namespace echoway::fuzz {

struct JavaEnv::Object {
  std::u16string text{};
  std::unique_ptr<std::byte[]> memory{};
  std::size_t size = 0;
  std::vector<jobject> elements{};
};

// The reference that native code holds is the object's own address, as opaque to it as a real one.
JavaEnv::Object& JavaEnv::object(jobject reference) { return *reinterpret_cast<Object*>(reference); }

JavaEnv& JavaEnv::of(JNIEnv* env) { return *static_cast<JavaEnv*>(env->functions->reserved0); }

JavaEnv::JavaEnv() {
  functions_.reserved0 = this;
  functions_.GetStringLength = [](JNIEnv*, jstring text) { return static_cast<jsize>(object(text).text.size()); };
  functions_.GetStringRegion = [](JNIEnv*, jstring text, jsize start, jsize length, jchar* out) {
    std::copy_n(object(text).text.begin() + start, length, out);
  };
  functions_.NewString = [](JNIEnv* env, const jchar* units, jsize length) {
    return of(env).string({units, units + length});
  };
  functions_.GetDirectBufferAddress = [](JNIEnv*, jobject buffer) -> void* { return object(buffer).memory.get(); };
  functions_.GetDirectBufferCapacity = [](JNIEnv*, jobject buffer) {
    return object(buffer).memory ? static_cast<jlong>(object(buffer).size) : jlong{-1};
  };
  functions_.SetObjectArrayElement = [](JNIEnv*, jobjectArray array, jsize index, jobject value) {
    object(array).elements.at(static_cast<std::size_t>(index)) = value;
  };
  env_.functions = &functions_;
}

JavaEnv::~JavaEnv() = default;

JavaEnv::Object* JavaEnv::keep(std::unique_ptr<Object> object) {
  return objects_.emplace_back(std::move(object)).get();
}

jstring JavaEnv::string(std::u16string text) {
  auto made = std::make_unique<Object>();
  made->text = std::move(text);
  return reinterpret_cast<jstring>(keep(std::move(made)));
}

jobject JavaEnv::buffer(std::size_t size) {
  auto made = std::make_unique<Object>();
  made->memory = std::make_unique<std::byte[]>(size);
  made->size = size;
  return reinterpret_cast<jobject>(keep(std::move(made)));
}

jobject JavaEnv::heap_buffer() { return reinterpret_cast<jobject>(keep(std::make_unique<Object>())); }

jobjectArray JavaEnv::array(std::size_t size) {
  auto made = std::make_unique<Object>();
  made->elements.resize(size);
  return reinterpret_cast<jobjectArray>(keep(std::move(made)));
}

std::byte* JavaEnv::bytes(jobject buffer) { return object(buffer).memory.get(); }

const std::u16string* JavaEnv::first(jobjectArray array) {
  const std::vector<jobject>& elements = object(array).elements;
  return elements.empty() || elements[0] == nullptr ? nullptr : &object(elements[0]).text;
}

}  // namespace echoway::fuzz
