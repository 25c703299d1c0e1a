// What a tuner turns: the numbers among a planner's parameters, and other values of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/local_planner/planner_registry.hpp"

namespace bw::tune {

struct TunedParameter {
  std::string name;  ///< as --set of a bench has it
  double value = 0.0;
  double min = 0.0, max = 0.0;  ///< that it may have; not finite where there is no end
  bool integer = false;
};

/// Numbers among the parameters of the planner's section, of `teb` where it drives bands, and of what all planners share.
/// `names`: these instead. `set`: overrides that their values have. Throws std::runtime_error for a name that is no number of a planner.
std::vector<TunedParameter> parameters_of(const std::string& planner, const std::vector<std::string>& names,
                                          const std::vector<std::string>& set = {});

/// --set for candidate `number`, from `seed`: nothing for 0, which is where they begin. Others differ in half of the parameters, each
/// by a factor drawn up to `widest` either way, equal in the logarithm, within what it may have; of a value of 0 nothing is
/// changed.
std::vector<std::string> settings_of(const std::vector<TunedParameter>& parameters, std::size_t number,
                                     std::uint64_t seed, double widest = 3.0);

}  // namespace bw::tune
