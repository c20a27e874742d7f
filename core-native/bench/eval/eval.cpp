// Measures the tracker on simulated walks: many buildings, worlds and walks, with and without motion hints, from a known
// start or none. Prints one line a group; --verbose one a walk.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "buildings.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"

namespace echoway::eval {
namespace {

struct Options {
  int walks = 16;
  int first = 1;
  double seconds = 60.0;
  int rooms = 4;
  bool hints = true;
  bool known = true;
  bool teleport = false;
  bool verbose = false;
  int particles = 0;
  sim::Profile profile = sim::Profile::furnished;
  std::string building;   // Empty: a random office for every walk.
  double pace_mps = 0.5;
  double cover = 0.0;
  int processes = 2;
};

struct Score {
  double mean_m = 0.0, heading_deg = 0.0, room_share = 0.0, within = 0.0, micros = 0.0, worst_micros = 0.0, found_s = -1.0;
  double mean_sigma = 0.0;
  int firings = 0;
};

Score run(const Building& building, const sim::Simulation& s, const Options& o, std::uint64_t seed) {
  Start start;
  const auto& first = s.truth.front();
  if (o.known) {
    Random r(seed);
    start.room = building.find_room(first.room);
    start.position = first.pose.position;
    start.heading = first.pose.heading;
  }
  BeltConfig belt = s.scans.belt.apply_to({});
  BayesOptions options;
  options.seed = seed;
  if (o.particles > 0) options.particles = options.particles_without_gyroscope = o.particles;
  BayesLocator locator(building, belt, start, options);
  Score out;
  std::size_t hint = 0;
  double right_since = -1.0;
  const double t0 = s.scans.firings.front().time_s;
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
  };
  for (std::size_t i = 0; i < s.scans.firings.size(); ++i) {
    const Firing& f = s.scans.firings[i];
    const double before = now();
    while (o.hints && hint < s.motion.size() && s.motion[hint].time_s <= f.time_s) locator.on_motion(s.motion[hint++]);
    locator.on_firing(f);
    const double us = now() - before;
    out.micros += us;
    out.worst_micros = std::max(out.worst_micros, us);
    const Estimate& e = locator.estimate();
    const auto& truth = s.truth[i];
    const RoomIndex room = building.find_room(truth.room);
    double error = 20.0, turn = kPi;
    if (e.room != kNoRoom) {
      const Pose2 a = building.room(e.room).frame.compose(e.pose);
      const Pose2 b = building.room(room).frame.compose(truth.pose);
      error = distance(a.position, b.position);
      turn = std::abs(wrap_angle(a.heading - b.heading));
    }
    out.mean_m += error;
    out.heading_deg += to_degrees(turn);
    out.room_share += e.room == room;
    out.within += error <= 2.0 * e.sigma_m;
    out.mean_sigma += e.sigma_m;
    const bool right = e.room == room && error < kMetresPerFoot;
    if (right && right_since < 0.0) right_since = f.time_s;
    if (!right) right_since = -1.0;
    // Found: right for three seconds in a row; the moment when that began counts.
    if (out.found_s < 0.0 && right && f.time_s - right_since > 3.0) out.found_s = right_since - t0;
    ++out.firings;
    if (o.verbose && std::getenv("TRACE") && i % 16 == 0)
      std::printf("   t %.1f true %s %.2f %.2f %.0f | est %s %.2f %.2f %.0f sigma %.2f p %.2f %d  err %.2f nh %zu k %.3f v %.2f\n", f.time_s, truth.room.c_str(),
                  truth.pose.position.x, truth.pose.position.y, to_degrees(truth.pose.heading), e.room < 0 ? "-" : building.room(e.room).id.c_str(),
                  e.pose.position.x, e.pose.position.y, to_degrees(e.pose.heading), e.sigma_m, e.room_probability, int(e.state), error,
                  locator.hypotheses().size(), e.sound_speed_scale, e.speed_mps);
  }
  const double n = out.firings;
  out.mean_m /= n;
  out.heading_deg /= n;
  out.room_share /= n;
  out.within /= n;
  out.micros /= n;
  out.mean_sigma /= n;
  return out;
}

Building load(const std::string& dir) {
  Result<Building> building = load_building(dir);
  if (building) return std::move(*building);
  std::fprintf(stderr, "%s\n", building.error().to_string().c_str());
  std::exit(2);
}

Score one(const Options& o, int k) {
  const Building building = o.building.empty() ? random_office(o.rooms, static_cast<std::uint64_t>(k)) : load(o.building);
  sim::RandomWalkOptions w;
  w.speed_mps = o.pace_mps;
  w.teleport_probability = o.teleport ? 0.1 : 0.0;
  w.cover_probability = o.cover;
  w.duration_s = o.seconds;
  w.profile = o.profile;
  auto walk = sim::random_walk(building, w, static_cast<std::uint64_t>(k) * 101 + 7);
  auto s = sim::simulate(building, walk);
  if (!s.ok()) {
    std::fprintf(stderr, "walk %d: %s\n", k, s.error().to_string().c_str());
    return {};
  }
  return run(building, *s, o, static_cast<std::uint64_t>(k));
}

}  // namespace
}  // namespace echoway::eval

int main(int argc, char** argv) {
  using namespace echoway;
  using namespace echoway::eval;
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::atof(argv[++i]) : 0.0; };
    if (a == "--walks") o.walks = static_cast<int>(value());
    else if (a == "--first") o.first = static_cast<int>(value());
    else if (a == "--seconds") o.seconds = value();
    else if (a == "--rooms") o.rooms = static_cast<int>(value());
    else if (a == "--no-hints") o.hints = false;
    else if (a == "--unknown") o.known = false;
    else if (a == "--verbose") o.verbose = true;
    else if (a == "--particles") o.particles = static_cast<int>(value());
    else if (a == "--teleport") o.teleport = true;
    else if (a == "--cover") o.cover = value();
    else if (a == "--speed") o.pace_mps = value();
    else if (a == "--building" && i + 1 < argc) o.building = argv[++i];
    else if (a == "--empty") o.profile = sim::Profile::empty;
    else if (a == "--hard") o.profile = sim::Profile::hard;
    else if (a == "--processes") o.processes = static_cast<int>(value());
  }
  std::vector<Score> results(static_cast<std::size_t>(o.walks));
  std::vector<int> pipes;
  for (int p = 0; p < o.processes; ++p) {
    int fd[2];
    if (pipe(fd) != 0) return 1;
    if (fork() == 0) {
      if (nice(10) == -1) {}
      for (int k = p; k < o.walks; k += o.processes) {
        const Score r = one(o, o.first + k);
        if (write(fd[1], &r, sizeof r) != sizeof r) return 1;
        std::fflush(stdout);
      }
      return 0;
    }
    close(fd[1]);
    pipes.push_back(fd[0]);
  }
  for (int p = 0; p < o.processes; ++p)
    for (int k = p; k < o.walks; k += o.processes)
      if (read(pipes[static_cast<std::size_t>(p)], &results[static_cast<std::size_t>(k)], sizeof(Score)) != sizeof(Score)) std::fprintf(stderr, "walk lost\n");
  while (wait(nullptr) > 0) {}
  Score sum;
  double worst = 0.0;
  int found20 = 0, found40 = 0, good = 0;
  double firings = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Score& r = results[k];
    if (o.verbose)
      std::printf("  %3d: mean %.3f ft  heading %.2f  room %.4f  2s %.3f  us %.0f (max %.0f) found %.1f sigma %.3f ft\n", o.first + static_cast<int>(k), r.mean_m / kMetresPerFoot,
                  r.heading_deg, r.room_share, r.within, r.micros, r.worst_micros, r.found_s, r.mean_sigma / kMetresPerFoot);
    if (r.firings == 0) continue;
    ++good;
    const double f = r.firings;
    firings += f;
    sum.mean_m += f * r.mean_m;
    sum.heading_deg += f * r.heading_deg;
    sum.room_share += f * r.room_share;
    sum.within += f * r.within;
    sum.micros += f * r.micros;
    sum.worst_micros = std::max(sum.worst_micros, r.worst_micros);
    worst = std::max(worst, r.mean_m);
    found20 += r.found_s >= 0.0 && r.found_s <= 20.0;
    found40 += r.found_s >= 0.0 && r.found_s <= 40.0;
  }
  std::printf("%d walks: mean %.3f ft worst %.3f ft  room %.4f  heading %.2f deg  2sigma %.3f  us %.1f (max %.0f)  found20 %.2f found40 %.2f\n", good,
              sum.mean_m / firings / kMetresPerFoot, worst / kMetresPerFoot, sum.room_share / firings, sum.heading_deg / firings, sum.within / firings,
              sum.micros / firings, sum.worst_micros, double(found20) / good, double(found40) / good);
}
