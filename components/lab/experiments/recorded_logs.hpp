// The logs of experiment E7, imported from their tables.
#pragma once

#include <filesystem>

#include "components/lab/experiments/localization_real_data.hpp"

namespace bw {

/// `data` holds the logs' folders; their columns files are those of config/imports. Throws what the import
/// throws.
RealDataLogs read_real_data(const std::filesystem::path& data);

}  // namespace bw
