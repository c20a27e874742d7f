#include "tracker/stillness.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/units.hpp"
#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

// Of a hundred echoes of who stands ninety repeat the last one, give or take so much (a Cauchy distribution: some come
// from another part of the same thing) ...
constexpr double kRepeated = 0.9;
constexpr double kSpread = 0.01;               // Metres,
constexpr double kSpreadPerMetre = 0.005;
constexpr double kAnything = 0.02;             // and the rest have this density, per metre.
// ... of who walks seventy change by up to what they walked meanwhile, and the others by anything.
constexpr double kChanged = 0.7;
constexpr double kShareOfWay = 0.7;            // Standard deviation, of the way,
constexpr double kShortestWay = 0.3;           // metres.
constexpr double kAnythingElse = 0.03;         // Per metre.
constexpr double kEvidence = 0.3;              // Of it counts: shelves repeat themselves to who walks, too.

}  // namespace

double stillness(const EchoPair& pair, double pace) noexcept {
  const double change = std::abs(pair.range - pair.before);
  const double spread = kSpread + kSpreadPerMetre * pair.range;
  const double off = change / spread;
  const double same = kRepeated * 2.0 / (kPi * spread * (1.0 + off * off)) + kAnything;
  const double way = std::max(kShortestWay, kShareOfWay * pace * pair.seconds);
  const double far = change / way;
  const double other = kChanged * 2.0 * kInvSqrtTwoPi / way * fast_exp(-0.5 * far * far) + kAnythingElse;
  return fast_exp(kEvidence * fast_log(same / other));
}

}  // namespace echoway::tracker
