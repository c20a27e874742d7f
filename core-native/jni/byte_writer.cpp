#include "byte_writer.hpp"

#include <cstring>

namespace echoway::jni {

void ByteWriter::raw(const void* data, std::size_t size) noexcept {
  if (fits() && size <= out_.size() - size_) std::memcpy(out_.data() + size_, data, size);
  size_ += size;
}

void ByteWriter::i32(std::int32_t value) noexcept { raw(&value, sizeof value); }
void ByteWriter::i64(std::int64_t value) noexcept { raw(&value, sizeof value); }
void ByteWriter::f64(double value) noexcept { raw(&value, sizeof value); }

void ByteWriter::text(std::string_view value) noexcept {
  i32(static_cast<std::int32_t>(value.size()));
  if (!value.empty()) raw(value.data(), value.size());
}

}  // namespace echoway::jni
