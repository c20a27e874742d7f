// Error against one nuisance at a time.
#include <cmath>
#include <functional>
#include <optional>

#include "experiment.hpp"
#include "plans.hpp"
#include "roaming.hpp"
#include "stops.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

constexpr double kSeconds = 50.0;
constexpr double kSpeed = 0.5;

struct Setting {
  Building world;  ///< As it is walked through,
  Building plan;   ///< and as the estimators are told.
  sim::Walk walk;
};

/// One thing that goes wrong, to some degree.
struct Nuisance {
  std::string group;
  std::vector<double> levels;
  std::function<void(Setting&, double level, int number)> apply;
  std::optional<double> nothing{};  ///< The level, if any, at which nothing goes wrong at all.
  std::function<double(double level)> speed = [](double) { return kSpeed; };
};

void kill_sensors(Setting& setting, double count, int number) {
  if (count < 1.0) return;   // A fault that names no sensor is one of all.
  Random random(static_cast<std::uint64_t>(number) + 31);
  std::vector<int> sensors;
  for (int i = 0; i < setting.walk.belt.sensors; ++i) sensors.push_back(i);
  std::vector<int> dead;
  while (dead.size() < static_cast<std::size_t>(count)) {
    const auto pick = static_cast<std::ptrdiff_t>(random.uniform() * static_cast<double>(sensors.size()));
    dead.push_back(sensors[static_cast<std::size_t>(pick)]);
    sensors.erase(sensors.begin() + pick);
  }
  setting.walk.steps.insert(setting.walk.steps.begin(), {sim::SensorFault{sim::SensorFault::Kind::dead, dead, 0.0}});
}

double celsius_for(double sound_speed_error) {
  const double v = speed_of_sound(kReferenceCelsius) * (1.0 + sound_speed_error) / speed_of_sound(0.0);
  return 273.15 * (v * v - 1.0);
}

std::vector<Nuisance> nuisances() {
  return {
      {"dead sensors of 15", {0, 1, 2, 4, 6, 8}, kill_sensors, 0},
      {"drop-outs (%)",
       {0, 10, 20, 30, 45, 60},
       [](Setting& s, double level, int) { s.walk.world.dropout = level / 100.0; }},
      {"unmapped furniture a square metre",
       {0, 0.05, 0.1, 0.2, 0.3, 0.45},
       [](Setting& s, double level, int) { s.walk.world.furniture_per_m2 = s.walk.world.posts_per_m2 = level; }},
      {"people on 100 square metres",
       {0, 2, 5, 10, 20},
       [](Setting& s, double level, int) { s.walk.world.people_per_100m2 = level; }},
      {"walking speed (m/s)",
       {0.5, 0.75, 1.0, 1.25, 1.5},
       [](Setting&, double, int) {},
       kSpeed,
       [](double level) { return level; }},
      {"sound speed off (%)",
       {-4, -2, -1, 0, 1, 2, 4},
       [](Setting& s, double level, int) {
         s.walk.world.temperature_c = celsius_for(level / 100.0);
         s.walk.world.temperature_gradient_k_per_m = 0.0;
       }},
      {"phone swinging in a pocket (degrees)",
       {0, 4, 8, 12, 16},
       [](Setting& s, double level, int) { s.walk.world.phone_swing_rad = degrees(level); },
       0},
      {"walls off (cm)",
       {0, 2, 5, 10, 20},
       [](Setting& s, double level, int number) {
         s.plan = walls_off(s.world, level / 100.0, static_cast<std::uint64_t>(number) + 77);
       },
       0},
      {"a cupboard a room that the plan lacks",
       {0, 1},
       [](Setting& s, double, int number) {
         s.world = with_cupboards(s.world, static_cast<std::uint64_t>(number) + 5);
       },
       0},
      {"a cupboard a room that is gone",
       {0, 1},
       [](Setting& s, double, int number) {
         s.plan = with_cupboards(s.world, static_cast<std::uint64_t>(number) + 5);
       },
       0},
      {"a partition a room moved (m)",
       {0, 0.25, 0.5, 1.0},
       [](Setting& s, double level, int) { s.plan = partitions_moved(s.world, level); },
       0},
  };
}

struct Job {
  const Nuisance* nuisance;  ///< None: nothing goes wrong.
  double level;
  int number;
  bool echoes_alone;  ///< Follow it by echoes alone too.
};

// The walk where nothing goes wrong is the first level of many a nuisance, and walked once.
std::vector<std::pair<std::string, double>> names_of(const Job& job, const std::vector<Nuisance>& all) {
  if (job.nuisance != nullptr) return {{job.nuisance->group, job.level}};
  std::vector<std::pair<std::string, double>> names;
  for (const Nuisance& nuisance : all) {
    if (nuisance.nothing) names.emplace_back(nuisance.group, *nuisance.nothing);
  }
  return names;
}

std::string one_walk(const Job& job, const std::vector<Nuisance>& all) {
  Table rows;
  Roam roamed = roam(job.number, kSeconds, job.nuisance != nullptr ? job.nuisance->speed(job.level) : kSpeed);
  Setting setting{roamed.world, roamed.world, roamed.walk};
  if (job.nuisance != nullptr) job.nuisance->apply(setting, job.level, job.number);
  const auto run = sim::simulate(setting.world, setting.walk);
  if (!run) return {};  // The cupboard stands where the walk wants to go.
  std::vector<Estimator> methods{thesis_method(), tracker()};
  if (job.echoes_alone) methods.push_back(tracker_without_hints());
  for (const Estimator& method : methods) {
    const Track track = follow({setting.world, setting.plan, *run, kReferenceCelsius, setting.walk.seed}, method);
    const Summary s = summarise(track);
    for (const auto& [group, level] : names_of(job, all)) {
      rows.add(group, level, job.number, method.name, s.mean_m, s.median_m, s.p90_m, to_degrees(s.turn_rad),
               s.right_room, s.within_2_sigma, track.cpu_us());
    }
  }
  return rows.text();
}

// By echoes alone, which costs most, half of the walks are followed.
std::vector<Job> jobs_of(const std::vector<Nuisance>& all, int walks) {
  std::vector<Job> jobs;
  const auto add = [&](const Nuisance* nuisance, double level) {
    for (int number = 0; number < walks; ++number) jobs.push_back({nuisance, level, number, 2 * number < walks});
  };
  for (const Nuisance& nuisance : all) {
    for (const double level : nuisance.levels) {
      if (level != nuisance.nothing) add(&nuisance, level);
    }
  }
  add(nullptr, 0.0);
  return jobs;
}

}  // namespace

void run_robustness(const Context& context) {
  const std::vector<Nuisance> all = nuisances();
  const std::vector<Job> jobs = jobs_of(all, context.repeats(16));
  const auto parts = run_all(context, static_cast<int>(jobs.size()),
                             [&](int i) { return one_walk(jobs[static_cast<std::size_t>(i)], all); });
  Table table(kRoamColumns);
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "robustness.csv");
}

}  // namespace echoway::report
