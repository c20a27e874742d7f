#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace echoway::jni {

/// Writes values one after the other into a buffer, in the machine's byte order and without padding. Keeps counting
/// when the buffer is full, so that a first try tells how large it must be.
class ByteWriter {
 public:
  explicit ByteWriter(std::span<std::byte> out) noexcept : out_(out) {}

  void i32(std::int32_t value) noexcept;
  void i64(std::int64_t value) noexcept;
  void f64(double value) noexcept;
  /// Length in bytes (i32), then UTF-8.
  void text(std::string_view value) noexcept;
  void raw(const void* data, std::size_t size) noexcept;

  /// Bytes that everything so far takes.
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool fits() const noexcept { return size_ <= out_.size(); }

 private:
  std::span<std::byte> out_;
  std::size_t size_ = 0;
};

}  // namespace echoway::jni
