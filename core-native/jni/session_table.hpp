#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "echoway/session.hpp"

namespace echoway::jni {

/// Sessions that Kotlin holds handles to. A handle is a number that is never used twice, so that a stale one is refused
/// instead of followed; a session that is closed while a call runs in it lives until that call returns.
class SessionTable {
 public:
  /// Never 0.
  std::int64_t add(std::unique_ptr<Session> session);
  /// Null when the handle is stale or was never given out.
  [[nodiscard]] std::shared_ptr<Session> find(std::int64_t handle);
  void remove(std::int64_t handle);

 private:
  std::mutex mutex_;
  std::unordered_map<std::int64_t, std::shared_ptr<Session>> sessions_;
  std::int64_t next_ = 1;
};

SessionTable& session_table();

}  // namespace echoway::jni
