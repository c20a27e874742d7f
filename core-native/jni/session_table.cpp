#include "session_table.hpp"

namespace echoway::jni {

std::int64_t SessionTable::add(std::unique_ptr<Session> session) {
  const std::lock_guard lock(mutex_);
  const std::int64_t handle = next_++;
  sessions_.emplace(handle, std::move(session));
  return handle;
}

std::shared_ptr<Session> SessionTable::find(std::int64_t handle) {
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(handle);
  return found == sessions_.end() ? nullptr : found->second;
}

void SessionTable::remove(std::int64_t handle) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(handle);
}

SessionTable& session_table() {
  static SessionTable table;
  return table;
}

}  // namespace echoway::jni
