#include "session/make_locator.hpp"

#include "echoway/tracker/bayes_locator.hpp"

namespace echoway {

Result<std::unique_ptr<Locator>> make_locator(const Building& building, const SessionConfig& config) {
  if (config.method == Method::thesis) return Error{"the thesis's method is not part of this build yet"};
  BayesOptions options;
  options.seed = config.seed;
  return std::unique_ptr<Locator>(std::make_unique<BayesLocator>(building, config.belt, config.start, options));
}

}  // namespace echoway
