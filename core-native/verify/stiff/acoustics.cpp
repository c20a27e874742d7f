// The receiver response of Kuc and Siegel and the piston's directivity where their formulas are 0/0 or nearly so.
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "echoway/acoustics/kuc_siegel.hpp"
#include "echoway/acoustics/transducer.hpp"
#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
constexpr std::array kRadii{0.0, kDenormal, 1e-12, 0.0163, 0.0192, 1e3};
constexpr std::array kDistances{0.0, 1e-9, 0.15, 10.67, 1e9};
constexpr std::array kPeriods{1e-9, 1e-6, 1e-3};

struct Setting {
  double radius;
  double distance;
  double period;
};

std::string describe(const Setting& s) {
  return "radius " + number(s.radius) + " m, distance " + number(s.distance) + " m, period " + number(s.period) + " s";
}

Transducer with_radius(double radius) {
  Transducer transducer;
  transducer.radius_m = radius;
  return transducer;
}

/// Every radius with every period, and every distance: the shape does not depend on the distance, so these two need not
/// be multiplied.
std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const double radius : kRadii) {
    for (const double period : kPeriods) all.push_back({radius, 3.0, period});
  }
  for (const double distance : kDistances) all.push_back({0.0192, distance, 1e-6});
  return all;
}

/// The largest of `error(setting)` over every setting, and where that was.
template <class Error>
Outcome sweep(std::string expected, double bound, Error error) {
  double largest = 0.0;
  std::string where = "everywhere";
  for (const Setting& setting : settings()) {
    const double e = error(setting);
    if (e <= largest) continue;
    largest = larger(largest, e);
    where = describe(setting);
  }
  return worst(std::move(expected), largest, Unit::absolute, bound, std::move(where));
}

/// cos(a) in front, 0 at and beyond 90 degrees.
double heard(double inclination) {
  return std::fabs(inclination) < 0.5 * kPi ? std::fmax(0.0, std::cos(inclination)) : 0.0;
}

/// Neumaier's sum: 262,145 cells lose digits to a plain one, and the error shall be the response's, not the adding's.
double compensated_sum(std::span<const double> values) {
  double sum = 0.0;
  double lost = 0.0;
  for (const double value : values) {
    const double next = sum + value;
    lost += std::fabs(sum) >= std::fabs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
  }
  return sum + lost;
}

/// Infinite when the shape is wrong: negative, lopsided, not centred at `centre`, or an even number of cells.
double shape_error(const CellResponse& response, double centre) {
  const std::vector<double>& mass = response.mass;
  if (mass.size() % 2 != 1 || mass.size() > kMaxCells) return std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (!(mass[i] >= 0.0) || mass[i] != mass[mass.size() - 1 - i]) return std::numeric_limits<double>::infinity();
  }
  return std::fabs(response.centre_s - centre) / std::fmax(centre, std::numeric_limits<double>::min());
}

/// J1 by Miller's downward recurrence, normalised by J0 + 2 (J2 + J4 + ...) = 1: shares nothing with the core's series.
double bessel_j1(double x) {
  const int start = 2 * (static_cast<int>(x) / 2 + 60);
  double above = 0.0;
  double here = 1e-30;
  double norm = 0.0;
  double j1 = 0.0;
  for (int n = start; n > 0; --n) {
    const double below = 2.0 * n / x * here - above;
    above = here;
    here = below;
    if (n - 1 == 1) j1 = here;
    if ((n - 1) % 2 == 0) norm += n - 1 == 0 ? here : 2.0 * here;
    if (std::fabs(here) > 1e200) {
      above *= 1e-200;
      here *= 1e-200;
      norm *= 1e-200;
      j1 *= 1e-200;
    }
  }
  return j1 / norm;
}

/// The response's transform at the carrier, cell by cell at the cells' centres.
double transform_at_carrier(const Transducer& transducer, const CellResponse& response) {
  const double w = kTwoPi * transducer.frequency_hz;
  double sum = 0.0;
  for (std::size_t i = 0; i < response.mass.size(); ++i) {
    const auto offset = static_cast<double>(static_cast<std::ptrdiff_t>(i) - response.half());
    sum += response.mass[i] * std::cos(w * offset * response.period_s);
  }
  return sum;
}

struct Inclination {
  const char* name;
  double radians;
};

const std::vector<Inclination>& inclinations() {
  const double k = Transducer{}.wavenumber();
  static const std::vector<Inclination> all{
      {"0", 0.0},
      {"a denormal", kDenormal},
      {"1e-300", 1e-300},
      {"1e-12", 1e-12},
      {"1e-9", 1e-9},
      {"1e-6", 1e-6},
      {"1e-5", 1e-5},
      {"1e-3", 1e-3},
      {"the first null of a 19.2 mm piston", std::asin(3.8317059702075123 / (k * 0.0192))},
      {"the first null of a 16.3 mm piston", std::asin(3.8317059702075123 / (k * 0.0163))},
      {"the second null of a 19.2 mm piston", std::asin(7.0155866698156188 / (k * 0.0192))},
      {"45 degrees", 0.25 * kPi},
      {"90 degrees less 1e-12", 0.5 * kPi - 1e-12},
      {"the double below 90 degrees", std::nextafter(0.5 * kPi, 0.0)},
      {"90 degrees", 0.5 * kPi},
      {"90 degrees and 1e-12", 0.5 * kPi + 1e-12},
      {"120 degrees", degrees(120.0)},
      {"180 degrees", kPi},
      {"-30 degrees", degrees(-30.0)},
  };
  return all;
}

void add_responses(std::vector<Case>& table) {
  for (const Inclination& a : inclinations()) {
    const double cosine = heard(a.radians);
    table.push_back({"Receiver response", "integral of h_R, inclination " + std::string(a.name), [=] {
                       return sweep("cos(a) = " + number(cosine), 1e-12, [&](const Setting& s) {
                         const CellResponse r =
                             receiver_response(with_radius(s.radius), s.distance, a.radians, s.period);
                         return std::fabs(compensated_sum(r.mass) - cosine);
                       });
                     }});
    table.push_back({"Receiver response", "integral of h_T * h_R, inclination " + std::string(a.name), [=] {
                       return sweep("cos(a)^2 = " + number(cosine * cosine), 1e-12, [&](const Setting& s) {
                         const CellResponse r =
                             transmit_receive_response(with_radius(s.radius), s.distance, a.radians, s.period);
                         return std::fabs(compensated_sum(r.mass) - cosine * cosine);
                       });
                     }});
    table.push_back({"Receiver response", "shape of h_T * h_R, inclination " + std::string(a.name), [=] {
                       return sweep("centred at 2z/c, symmetric to the last bit, nowhere negative", 4.5e-16,
                                    [&](const Setting& s) {
                                      const Transducer t = with_radius(s.radius);
                                      return shape_error(
                                          transmit_receive_response(t, s.distance, a.radians, s.period),
                                          2.0 * s.distance / t.sound_speed_mps);
                                    });
                     }});
  }
}

void add_transforms(std::vector<Case>& table) {
  for (const double degrees_off : {0.0, 1e-4, 1.0, 5.0, 12.7, 15.1, 30.0, 60.0, 89.9}) {
    table.push_back({"Receiver response",
                     "transform of h_R at 49.4 kHz against the directivity, " + number(degrees_off) + " degrees", [=] {
                       const Transducer t;
                       const double a = degrees(degrees_off);
                       const CellResponse r = receiver_response(t, 3.0, a, 1e-9);
                       const double x = t.wavenumber() * t.radius_m * std::sin(a);
                       const double expected = std::cos(a) * piston_directivity(x);
                       return within(expected, transform_at_carrier(t, r), Unit::absolute, 1e-7);
                     }});
  }
}

void add_directivity(std::vector<Case>& table) {
  for (const double x : {0.0, kDenormal, 1e-300, 1e-12, 1e-8}) {
    table.push_back({"Piston directivity", "2 J1(x)/x at x = " + number(x),
                     [=] { return within(1.0, piston_directivity(x), Unit::ulps, 1.0); }});
  }
  for (const double null : {3.8317059702075123, 7.0155866698156188, 10.173468135062722, 195.56222515966257}) {
    table.push_back({"Piston directivity", "at the null x = " + number(null), [=] {
                       return within(0.0, piston_directivity(null), Unit::absolute, null < 60.0 ? 1e-14 : 1e-12);
                     }});
  }
  struct Range {
    double from, to, bound;
  };
  for (const Range range : {Range{1e-3, 2.0, 1e-14}, Range{2.0, 59.99, 1e-14}, Range{60.0, 1000.0, 1e-12}}) {
    table.push_back(
        {"Piston directivity", "2,000 arguments from " + number(range.from) + " to " + number(range.to), [=] {
           double largest = 0.0;
           std::string where;
           for (int i = 0; i <= 2000; ++i) {
             const double x = range.from * std::pow(range.to / range.from, i / 2000.0);
             const double e = std::fabs(piston_directivity(x) - 2.0 * bessel_j1(x) / x);
             if (!(e <= largest)) where = "x = " + number(x);
             largest = larger(largest, e);
           }
           return worst("Miller's recurrence", largest, Unit::absolute, range.bound, where);
         }});
  }
  table.push_back({"Piston directivity", "even, bounded and finite for every magnitude from 1e-308 to 1e308", [] {
                     bool good = true;
                     for (int e = -308; e <= 308; ++e) {
                       const double x = std::pow(10.0, e);
                       const double d = piston_directivity(x);
                       good = good && d == piston_directivity(-x) && d >= -0.1323 && d <= 1.0;
                     }
                     return holds("in [-0.1323, 1]", good, good ? "yes" : "no");
                   }});
}

void add_nonsense(std::vector<Case>& table) {
  table.push_back({"Receiver response", "NaN, infinity and negative values in every argument", [] {
                     const double nan = std::numeric_limits<double>::quiet_NaN();
                     const double inf = std::numeric_limits<double>::infinity();
                     bool empty = true;
                     for (const double bad : {nan, inf, -inf}) {
                       empty = empty && receiver_response(with_radius(bad), 1.0, 0.1, 1e-6).mass.empty() &&
                               receiver_response(Transducer{}, bad, 0.1, 1e-6).mass.empty() &&
                               receiver_response(Transducer{}, 1.0, bad, 1e-6).mass.empty() &&
                               transmit_receive_response(Transducer{}, 1.0, 0.1, bad).mass.empty();
                     }
                     empty = empty && receiver_response(Transducer{}, -1.0, 0.1, 1e-6).mass.empty() &&
                             receiver_response(Transducer{}, 1.0, 0.1, 0.0).mass.empty();
                     return holds("no response", empty, empty ? "no response" : "something");
                   }});
}

}  // namespace

void add_acoustics(std::vector<Case>& table) {
  add_responses(table);
  add_nonsense(table);
  add_transforms(table);
  add_directivity(table);
}

}  // namespace echoway::stiff
