#include "readings.hpp"

namespace echoway::report {
namespace {

constexpr std::string_view name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::wall:
      return "wall";
    case ElementKind::corner:
      return "corner";
    case ElementKind::edge:
      return "edge";
    case ElementKind::reflector:
      return "all-reflective";
    case ElementKind::none:
      break;
  }
  return "none";
}

}  // namespace

void add_readings(std::string_view figure, const thesis::Scan& scan, const RangeModel& model, const Pose2& pose,
                  Table& table) {
  for (int sensor = 0; sensor < model.belt().sensors; ++sensor) {
    const PredictedEcho echo = model.predict(pose, sensor);
    double real = Firing::kNoEcho;
    for (const thesis::Reading& reading : scan.readings()) {
      if (reading.sensor == sensor) real = reading.range_m;
    }
    table.add(figure, sensor, real, echo.range_m, name_of(echo.kind));
  }
}

}  // namespace echoway::report
