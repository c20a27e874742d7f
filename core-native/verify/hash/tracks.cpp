#include "hash/tracks.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdio>
#include <thread>
#include <utility>

#include "echoway/sim/random_walk.hpp"
#include "plans/plans.hpp"

namespace echoway::tracks {
namespace {

struct Job {
  const char* name;
  Method method;
  bool start_known;
  sim::Profile profile;
  std::uint64_t seed;
  Building (*plan)() = plans::three_rooms;
  bool hints = true;
};

/// Many places in it explain the echoes equally well.
Building hall() { return plans::alone(plans::box_room("hall", 60.0, 2.4)); }

constexpr std::array kJobs{
    Job{"empty-bayes", Method::bayes, true, sim::Profile::empty, 1},
    Job{"furnished-bayes", Method::bayes, true, sim::Profile::furnished, 2},
    Job{"hard-search-bayes", Method::bayes, false, sim::Profile::hard, 3},
    Job{"furnished-search-bayes", Method::bayes, false, sim::Profile::furnished, 4},
    Job{"hall-search-bayes", Method::bayes, false, sim::Profile::empty, 5, hall},
    Job{"furnished-echoes-alone-bayes", Method::bayes, true, sim::Profile::furnished, 6, plans::three_rooms, false},
    Job{"empty-thesis", Method::thesis, true, sim::Profile::empty, 1},
    Job{"furnished-search-thesis", Method::thesis, false, sim::Profile::furnished, 2},
};

class Fnv1a {
 public:
  void add(std::uint64_t value) noexcept {
    for (int i = 0; i < 8; ++i, value >>= 8) hash_ = (hash_ ^ (value & 0xff)) * 0x100000001b3ULL;
  }
  /// Of the bits, so that -0 and 0 differ.
  void add(double value) noexcept { add(std::bit_cast<std::uint64_t>(value)); }
  [[nodiscard]] std::uint64_t value() const noexcept { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

Track run_one(const Job& job) {
  const Building building = job.plan();
  sim::RandomWalkOptions options;
  options.duration_s = 25.0;
  options.profile = job.profile;
  const sim::Walk walk = sim::random_walk(building, options, job.seed);
  Result<sim::Simulation> heard = sim::simulate(building, walk, job.seed);
  Track track{job.name, {}, {}};
  if (!heard || heard->truth.empty()) return track;
  if (!job.hints) heard->motion.clear();
  SessionConfig config;
  config.method = job.method;
  config.seed = job.seed;
  if (job.start_known) {
    const TruthRow& first = heard->truth.front();
    config.start = {building.find_room(first.room), first.pose.position, first.pose.heading};
  }
  track.scans = heard->scans.firings;
  track.estimates = follow(building, config, *heard);
  return track;
}

}  // namespace

std::vector<Estimate> follow(const Building& building, const SessionConfig& config, const sim::Simulation& walk) {
  std::vector<Estimate> estimates;
  auto opened = Session::open(building, config);
  if (!opened) return estimates;
  Session& session = **opened;
  auto hint = walk.motion.begin();
  for (const Firing& firing : walk.scans.firings) {
    for (; hint != walk.motion.end() && hint->time_s <= firing.time_s; ++hint) session.on_motion(*hint);
    if (session.on_firing(firing)) estimates.push_back(session.estimate());
  }
  return estimates;
}

std::vector<Track> run(int threads) {
  std::vector<Track> all(kJobs.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < kJobs.size(); i = next++) all[i] = run_one(kJobs[i]);
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  return all;
}

std::uint64_t hash_scans(const Track& track) {
  Fnv1a hash;
  for (const Firing& f : track.scans) {
    hash.add(f.time_s);
    hash.add(static_cast<std::uint64_t>(f.sensor));
    hash.add(f.range_m);
  }
  return hash.value();
}

std::uint64_t hash_estimates(const Track& track) {
  Fnv1a hash;
  for (const Estimate& e : track.estimates) {
    hash.add(static_cast<std::uint64_t>(e.room));
    hash.add(static_cast<std::uint64_t>(e.state));
    for (const double value : {e.time_s, e.pose.position.x, e.pose.position.y, e.pose.heading, e.sigma_m,
                               e.sigma_heading_rad, e.room_probability, e.covariance_xx, e.covariance_xy,
                               e.covariance_yy, e.speed_mps, e.sound_speed_scale}) {
      hash.add(value);
    }
  }
  return hash.value();
}

std::string hashes(const std::vector<Track>& all) {
  std::string text;
  for (const Track& track : all) {
    char line[160];
    std::snprintf(line, sizeof line, "%s %016llx %016llx %zu\n", track.name.c_str(),
                  static_cast<unsigned long long>(hash_scans(track)),
                  static_cast<unsigned long long>(hash_estimates(track)), track.estimates.size());
    text += line;
  }
  return text;
}

std::string rows(const std::vector<Track>& all) {
  std::string text;
  for (const Track& track : all) {
    for (const Estimate& e : track.estimates) {
      char line[200];
      std::snprintf(line, sizeof line, "%s,%.17g,%d,%.17g,%.17g,%.17g\n", track.name.c_str(), e.time_s, e.room,
                    e.pose.position.x, e.pose.position.y, e.pose.heading);
      text += line;
    }
  }
  return text;
}

}  // namespace echoway::tracks
