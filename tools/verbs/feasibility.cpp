// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/feasibility.hpp"

#include <fmt/format.h>

namespace legwright {
namespace {

constexpr double kLeastSpeedShare = 0.9;
constexpr double kLeastTurnShare = 0.9;
// What is missed by less is none that counts in a gait's cycle, however small a share is reached.
constexpr double kSpeedMiss = 1e-3;         // [m/s]
constexpr double kTurnMiss = 5e-3;          // [rad/s]
constexpr double kMostHeadingError = 0.35;  // [rad]
constexpr double kMostGroundError = 0.005;  // [m]
constexpr double kMostSlideShare = 0.5;     // of the distance travelled
constexpr double kMostRootResidual = 0.5;   // share of the weight

}  // namespace

std::vector<std::string> infeasible_reasons(bool usable, const PlanQuality& quality,
                                            const std::string& unit) {
  if (!usable) return {"no finite motion was found"};
  std::vector<std::string> reasons;
  const bool on_the_spot = unit == "rad/s";  // then the speed is that of the turn
  const auto misses = [](double reached, double wanted, double share, double least) {
    return reached < share * wanted && wanted - reached > least;
  };
  if (quality.speed_wanted > 0.0 && misses(quality.speed_reached, quality.speed_wanted,
                                           kLeastSpeedShare, on_the_spot ? kTurnMiss : kSpeedMiss))
    reasons.push_back(fmt::format("the plan reaches {:.3g} of {:.3g} {} ({:.0f} %)",
                                  quality.speed_reached, quality.speed_wanted, unit,
                                  100.0 * quality.speed_reached / quality.speed_wanted));
  if (!on_the_spot && misses(quality.turn_reached, quality.turn_wanted, kLeastTurnShare, kTurnMiss))
    reasons.push_back(fmt::format("the plan turns at {:.3g} of {:.3g} rad/s ({:.0f} %)",
                                  quality.turn_reached, quality.turn_wanted,
                                  100.0 * quality.turn_reached / quality.turn_wanted));
  if (quality.heading_error > kMostHeadingError)
    reasons.push_back(fmt::format(
        "the trunk turns by {:.2f} rad away from the wanted heading, so this is another task",
        quality.heading_error));
  if (quality.ground_error > kMostGroundError)
    reasons.push_back(
        fmt::format("a standing foot is {:.1f} mm off the ground", 1e3 * quality.ground_error));
  if (quality.slide_share > kMostSlideShare)
    reasons.push_back(fmt::format(
        "standing feet slide over {:.0f} % of the way; the body cannot step in that direction",
        100.0 * quality.slide_share));
  if (quality.root_residual > kMostRootResidual)
    reasons.push_back(fmt::format("forces of {:.0f} % of the weight are unexplained by the feet",
                                  100.0 * quality.root_residual));
  return reasons;
}

}  // namespace legwright
