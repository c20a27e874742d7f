#include "scene/cell_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "echoway/random.hpp"

namespace echoway::scene {
namespace {

// A cell with its own lists, all of them of one number.
struct Sample {
  std::vector<Cell::Entry> entries;
  std::vector<std::uint16_t> items;
  std::vector<std::uint16_t> occluders;

  Sample(std::uint16_t number, std::size_t sizes)
      : entries(sizes, {number, number, number}), items(5 * sizes, number), occluders(4 * sizes, number) {}

  [[nodiscard]] Cell cell() const {
    Cell c;
    c.entries = entries;
    c.items = items;
    c.occluders = occluders;
    return c;
  }

  [[nodiscard]] bool is(const Cell& c) const {
    const auto same = [](const Cell::Entry& a, const Cell::Entry& b) {
      return a.reflector == b.reflector && a.occluder_begin == b.occluder_begin && a.occluder_count == b.occluder_count;
    };
    return std::ranges::equal(c.entries, entries, same) && std::ranges::equal(c.items, items) &&
           std::ranges::equal(c.occluders, occluders);
  }
};

constexpr std::size_t kCells = 60;
constexpr std::size_t kLargest = 5000;          // Entries.
constexpr std::size_t kLargestBytes = kLargest * (sizeof(Cell::Entry) + 9 * sizeof(std::uint16_t));

TEST(CellStore, KeepsTheCellsPutLastAsTheyWere) {
  CellStore store(kCells, kLargestBytes);
  const std::size_t memory = store.memory();
  Random random(11);
  std::vector<Sample> put(kCells, Sample(0, 0));
  std::size_t puts = 0;
  for (std::size_t n = 0; n < 20000; ++n) {
    const std::size_t id = random.next() % kCells;
    if (store.find(id) != nullptr) continue;
    const std::size_t size = n % 500 == 0 ? kLargest : random.next() % (n % 2 == 0 ? 4 : 800);
    put[id] = Sample(static_cast<std::uint16_t>(n), size);
    EXPECT_TRUE(put[id].is(store.put(id, put[id].cell())));
    for (std::size_t other = 0; other < kCells; ++other) {
      const Cell* const found = store.find(other);
      ASSERT_TRUE(found == nullptr || put[other].is(*found)) << "cell " << other << " after " << n;
    }
    ASSERT_NE(store.find(id), nullptr);
    ++puts;
  }
  EXPECT_GT(puts, 20 * kCells) << "Memory must have been gone round many times.";
  EXPECT_EQ(store.memory(), memory);
}

TEST(CellStore, ForgetsNothingBeforeItsMemoryIsFull) {
  CellStore store(kCells, kLargestBytes);
  for (std::size_t id = 0; id < kCells; ++id) store.put(id, Sample(static_cast<std::uint16_t>(id), 10).cell());
  for (std::size_t id = 0; id < kCells; ++id) EXPECT_NE(store.find(id), nullptr) << id;
}

}  // namespace
}  // namespace echoway::scene
