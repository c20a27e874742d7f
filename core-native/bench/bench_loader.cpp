// Loading and checking a building of many rooms.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "echoway/building/loader.hpp"
#include "office_block.hpp"

namespace echoway {
namespace {

void load(benchmark::State& state) {
  const auto dir = write_office_block(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(load_building(dir).ok());
  std::filesystem::remove_all(dir);
}
BENCHMARK(load)->Name("load_building/rooms")->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

void check(benchmark::State& state) {
  const auto dir = write_office_block(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(check_building(dir).size());
  std::filesystem::remove_all(dir);
}
BENCHMARK(check)->Name("check_building/rooms")->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echoway
