// Counts every allocation of the process while a locator works.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/plans.hpp"

namespace {
std::atomic<long> allocations{0};

void* count_and_try(std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size == 0 ? 1 : size);
}

void* count_and_allocate(std::size_t size) {
  if (void* p = count_and_try(size)) return p;
  throw std::bad_alloc{};
}
}  // namespace

void* operator new(std::size_t size) { return count_and_allocate(size); }
void* operator new[](std::size_t size) { return count_and_allocate(size); }
// The standard library's own asks the one above, a sanitizer's does not.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return count_and_try(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return count_and_try(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace echoway {
namespace {

TEST(BayesLocator, AllocatesNothingWhileItSearchesAndTracks) {
  const Building building = test::small_office();
  sim::RandomWalkOptions options;
  options.duration_s = 20.0;
  const auto walk = sim::simulate(building, sim::random_walk(building, options, 11));
  ASSERT_TRUE(walk.ok());
  BayesLocator locator(building, {}, {});
  std::size_t hint = 0;
  const long before = allocations.load();
  for (const Firing& f : walk->scans.firings) {
    while (hint < walk->motion.size() && walk->motion[hint].time_s <= f.time_s) locator.on_motion(walk->motion[hint++]);
    locator.on_firing(f);
  }
  EXPECT_EQ(allocations.load() - before, 0);
}

}  // namespace
}  // namespace echoway
