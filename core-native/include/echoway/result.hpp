#pragma once

#include <string>
#include <utility>
#include <variant>

namespace echoway {

/// What went wrong, where. `file` and `line` are empty / 0 when the error has no place in a file.
struct Error {
  std::string message;   ///< What is wrong and, where it helps, what to do about it. One sentence, no trailing newline.
  std::string file = {}; ///< Path as the caller gave it.
  int line = 0;          ///< 1-based.

  /// `file:line: message`, the form in which every tool of the project prints it.
  [[nodiscard]] std::string to_string() const {
    if (file.empty()) return message;
    return line > 0 ? file + ":" + std::to_string(line) + ": " + message : file + ": " + message;
  }
};

/// A value or an Error; the core throws nothing across its public interface.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}       // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}   // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  /// REQUIRES: ok().
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T* operator->() { return &value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }

  /// REQUIRES: !ok().
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// For operations that return nothing but may fail.
using Status = Result<std::monostate>;

[[nodiscard]] inline Status success() { return std::monostate{}; }

}  // namespace echoway
