#include "session/make_locator.hpp"

#include "echoway/thesis/thesis_locator.hpp"
#include "echoway/tracker/bayes_locator.hpp"

namespace echoway {

Result<std::unique_ptr<Locator>> make_locator(const Building& building, const SessionConfig& config) {
  if (config.method == Method::thesis) return make_thesis_locator(building, config.belt, config.start);
  BayesOptions options;
  options.seed = config.seed;
  return std::unique_ptr<Locator>(std::make_unique<BayesLocator>(building, config.belt, config.start, options));
}

}  // namespace echoway
