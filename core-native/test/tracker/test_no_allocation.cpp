// Counts every allocation of the process and what is held of them, while a locator is made and works.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "support/plans.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace {
std::atomic<long> allocations{0};
std::atomic<long> bytes_held{0};

// In front of every block stands its size: not every operator delete is told.
constexpr std::size_t kHeader = alignof(std::max_align_t);

void* count_and_try(std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  void* block = std::malloc(size + kHeader);
  if (block == nullptr) return nullptr;
  bytes_held.fetch_add(static_cast<long>(size), std::memory_order_relaxed);
  *static_cast<std::size_t*>(block) = size;
  return static_cast<std::byte*>(block) + kHeader;
}

void count_and_free(void* p) noexcept {
  if (p == nullptr) return;
  void* block = static_cast<std::byte*>(p) - kHeader;
  bytes_held.fetch_sub(static_cast<long>(*static_cast<std::size_t*>(block)), std::memory_order_relaxed);
  std::free(block);
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
void operator delete(void* p) noexcept { count_and_free(p); }
void operator delete[](void* p) noexcept { count_and_free(p); }
void operator delete(void* p, std::size_t) noexcept { count_and_free(p); }
void operator delete[](void* p, std::size_t) noexcept { count_and_free(p); }

namespace echoway {
namespace {

class Allocations : public ::testing::TestWithParam<bool> {};   // With motion hints, and without.
INSTANTIATE_TEST_SUITE_P(Hints, Allocations, ::testing::Bool());

TEST_P(Allocations, AreNoneWhileTheTrackerSearchesAndTracks) {
  const Building building = test::small_office();
  sim::RandomWalkOptions options;
  options.duration_s = 20.0;
  const auto walk = sim::simulate(building, sim::random_walk(building, options, 11));
  ASSERT_TRUE(walk.ok());
  BayesLocator locator(building, {}, {});
  const long before = allocations.load();
  const auto doubt_for_a_moment = [&](std::size_t i) {
    const double now = walk->scans.firings[i].time_s;
    if (now > 12.0 && now < 12.1) locator.on_doubt();
  };
  test::play(*walk, locator, doubt_for_a_moment, GetParam());
  EXPECT_EQ(allocations.load() - before, 0);
}

// Rooms with a door in every wall see most of each other.
TEST(BayesLocator, HoldsLessThanTwentyMegabytesForAThousandRoomsWithADoorInEveryWall) {
  Building grid = test::make_grid(25, 40);
  for (Room& room : grid.rooms) room.corners = room.boundary.front();
  const long before = bytes_held.load();
  const BayesLocator locator(grid, {}, {});
  const long held = bytes_held.load() - before;
  EXPECT_GT(held, 1'000'000);
  EXPECT_LT(held, 20'000'000);
}

}  // namespace
}  // namespace echoway
