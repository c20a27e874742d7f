// Figures 6.13 to 6.15: what a wall counts against a corner.
#include <optional>

#include "experiment.hpp"
#include "plans.hpp"
#include "readings.hpp"
#include "rooms.hpp"
#include "table.hpp"

namespace echoway::report {
namespace {

const std::vector<double> kWeights{0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0};

std::string one_walk(const Building& room, int number) {
  Table rows;
  const CircularWalk circular =
      circular_walk(BeltConfig{}.sensors, sim::Profile::furnished, 600 + static_cast<std::uint64_t>(number));
  const sim::Simulation run = walk_through(room, circular.walk);
  const std::vector<Stop> stops = find_stops(room, run);
  for (Estimator method : {thesis_method(), thesis_as_printed()}) {
    for (const double weight : kWeights) {
      method.parameters.wall_weight = method.parameters.reflector_weight = weight;
      RoomMatcher matcher(room, 0, circular.walk.belt, method.parameters);
      Random random(static_cast<std::uint64_t>(number) + 1);  // The same approximate poses for every weight.
      for (std::size_t i = 0; i < stops.size(); ++i) {
        const Pose2& truth = stops[i].pose;
        const Pose2 start = approximate(room.room(0), truth, random);
        const thesis::Match match = matcher.match(scan_at(stops[i], run, method.parameters), start);
        const Pose2 pose = match.found ? match.pose : start;
        rows.add(number, method.name, weight, i, distance(pose.position, truth.position),
                 to_degrees(wrap_angle(pose.heading - truth.heading)));
      }
    }
  }
  return rows.text();
}

thesis::Match match_with(double weight, const Building& room, const CircularWalk& circular, const thesis::Scan& scan,
                         const Pose2& start) {
  ThesisParameters parameters = ThesisParameters::as_printed();
  parameters.wall_weight = weight;
  return RoomMatcher(room, 0, circular.walk.belt, parameters).match(scan, start);
}

// One place where the weights matter, chosen as the thesis chose its own: among all stops, the one at which equal
// weights lose most against two to one.
void show_one_place(const Context& context, const Building& room) {
  struct Case {
    double loss = 0.0;
    thesis::Scan scan{};
    Pose2 truth{}, start{};
    thesis::Match equal{}, unequal{};
  };
  std::optional<Case> worst;
  const CircularWalk circular = circular_walk(BeltConfig{}.sensors, sim::Profile::furnished, 600);
  const sim::Simulation run = walk_through(room, circular.walk);
  Random random(1);
  for (const Stop& stop : find_stops(room, run)) {
    Case c{0.0, scan_at(stop, run, {}), stop.pose, approximate(room.room(0), stop.pose, random), {}, {}};
    c.equal = match_with(1.0, room, circular, c.scan, c.start);
    c.unequal = match_with(2.0, room, circular, c.scan, c.start);
    c.loss = distance(c.equal.pose.position, c.truth.position) - distance(c.unequal.pose.position, c.truth.position);
    if (!worst || c.loss > worst->loss) worst = c;
  }
  Table poses("figure,kind,x_m,y_m,heading_deg");
  Table readings(kReadingColumns);
  const RoomMatcher matcher(room, 0, circular.walk.belt, {});
  for (const auto& [figure, match] : {std::pair{"6.13", worst->equal}, std::pair{"6.14", worst->unequal}}) {
    const Pose2& p = match.pose;
    poses.add(figure, "true", worst->truth.position.x, worst->truth.position.y, to_degrees(worst->truth.heading));
    poses.add(figure, "best", p.position.x, p.position.y, to_degrees(p.heading));
    add_readings(figure, worst->scan, matcher.matcher().model(), p, readings);
  }
  poses.write(context.out / "weights-poses.csv");
  readings.write(context.out / "weights-readings.csv");
}

}  // namespace

void run_weights(const Context& context) {
  const Building room = load_plan("sample-room");
  const auto parts = run_all(context, context.repeats(16), [&](int i) { return one_walk(room, i); });
  Table table("walk,method,weight,stop,error_m,turn_deg");
  for (const std::string& rows : parts) table.append(rows);
  table.write(context.out / "weights.csv");
  show_one_place(context, room);
}

}  // namespace echoway::report
