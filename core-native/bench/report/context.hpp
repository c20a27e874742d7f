#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

namespace echoway::report {

/// How an experiment is to be run.
struct Context {
  std::filesystem::path out;  ///< Folder for its tables.
  bool quick = false;         ///< A quarter of the walks.
  int threads = 1;

  [[nodiscard]] int repeats(int full) const noexcept { return quick ? (full + 3) / 4 : full; }
};

/// `work(0)` ... `work(count - 1)` on the context's threads; the results in that order, whatever the number of threads.
/// Throws what the first failing one threw.
template <class Work>
auto run_all(const Context& context, int count, Work work) {
  std::vector<decltype(work(0))> results(static_cast<std::size_t>(count));
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto serve = [&] {
    try {
      for (int i = next++; i < count; i = next++) results[static_cast<std::size_t>(i)] = work(i);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < context.threads; ++i) threads.emplace_back(serve);
  serve();
  threads.clear();  // joins
  if (failure) std::rethrow_exception(failure);
  return results;
}

}  // namespace echoway::report
