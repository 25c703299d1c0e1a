// What a recording of `bandwagon launch` tells of the faults in it.
#pragma once

#include <filesystem>
#include <vector>

#include "components/lab/battery/injection_judge.hpp"

namespace bw {

/// `bags`: of one drive, those that a recorder goes on with too. Throws std::runtime_error.
InjectedDrive read_injected_drive(const std::filesystem::path& bag, const std::vector<Injection>& injections);

}  // namespace bw
