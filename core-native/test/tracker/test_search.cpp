#include "tracker/search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tracker/plans.hpp"
#include "tracker/searching.hpp"

namespace echoway::tracker {
namespace {

constexpr RoomIndex kOffice = 1;
constexpr Vec2 kPlace{1.2, 3.4};
constexpr double kHeading = 0.4;
constexpr double kFarOff = -4.0;    // Log of how much worse a belief fits that is wrong, a firing.
constexpr double kWorthRefining = -1e6;

/// Somebody who stands in an office and hears what its plan says.
class SearchTest : public SearchingTest {
 protected:
  SearchTest() : SearchingTest(test::small_office()) {
    for (int pass = 0; pass < 2; ++pass) {
      for (int sensor = 0; sensor < belt_.sensors; ++sensor) hear(sensor);
    }
  }

  /// The belief made `log_more` more of each firing than the true place makes of it.
  void believe(double log_more) {
    History believed;
    for (std::uint64_t n = 0; n < history_.end(); ++n) {
      Record record = history_[n];
      record.log_main = log_density(record) + log_more;
      believed.push(record);
    }
    history_ = believed;
  }

  /// Slices of work until the search is over.
  int search(std::optional<double> least_gain) {
    SearchDomain everywhere;
    everywhere.least_gain = least_gain;
    search_.start(everywhere, 0, history_.end());
    int slices = 1;
    while (!search_.work(tools(), random_)) ++slices;
    return slices;
  }

  double found_here() {
    Population found(2400);
    search_.take(found, tools(), random_);
    double weight = 0.0;
    for (const Particle& p : found.particles()) {
      const bool here = p.room == kOffice && distance(p.position, kPlace) < 0.3;
      weight += here && std::abs(wrap_angle(p.heading - kHeading)) < 0.2 ? p.weight : 0.0;
    }
    return weight;
  }

  Search search_{scene_, Search::Parameters{}};

 private:
  static Particle wearer() {
    Particle p;
    p.room = kOffice;
    p.position = kPlace;
    p.heading = kHeading;
    p.facing = unit_from_angle(kHeading);
    p.cov.xx = p.cov.yy = 0.01;
    return p;
  }

  Shot shot_of_sensor(const Record& record) const {
    return shot_of(record, belt_, unit_from_angle(belt_.bearing(record.sensor)));
  }

  void hear(int sensor) {
    Record record = record_of(sensor);
    const ExpectedEchoes expected = expect(wearer(), shot_of_sensor(record), model_, scene_);
    record.echo = expected.count > 0;
    if (record.echo) record.range = expected.echo[0].range;
    history_.push(record);
  }

  double log_density(const Record& record) {
    return fast_log(weigh(wearer(), shot_of_sensor(record), model_, scene_).density);
  }
};

TEST_F(SearchTest, FindsWhereTheWearerIsWhenTheBeliefFitsNowhere) {
  believe(kFarOff);
  search(6.0);
  EXPECT_GT(search_.log_evidence(), kWorthRefining);
  EXPECT_GT(found_here(), 0.5);
}

TEST_F(SearchTest, FindsNothingBetterThanABeliefThatFits) {
  believe(0.0);
  search(6.0);
  EXPECT_LT(search_.log_evidence(), kWorthRefining);
}

TEST_F(SearchTest, ABeliefThatFitsIsSearchedAgainstWithLessWork) {
  believe(0.0);
  const int without_a_belief = search({});
  EXPECT_LT(search(6.0), without_a_belief);
}

}  // namespace
}  // namespace echoway::tracker
