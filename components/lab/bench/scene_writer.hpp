// Benchmark scenes back to YAML: what scene_file.hpp reads.
#pragma once

#include <string>

#include "components/lab/bench/scene_file.hpp"

namespace bw {

/// Reads back equal. Optional keys that SceneFile does not hold are left out.
std::string to_yaml(const SceneFile& file);

}  // namespace bw
