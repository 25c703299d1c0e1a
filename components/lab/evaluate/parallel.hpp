// `evaluate --jobs N`: the shards of an evaluation as processes, and their files.
#pragma once

#include <filesystem>
#include <vector>

#include "components/lab/evaluate/jobs.hpp"
#include "components/lab/evaluate/merge.hpp"

namespace bw {

/// Drives `count` jobs in up to 8 times as many shards as there are processes, below `folder`; those that are complete
/// there, made as `made` says, are taken as they are. A shard whose process dies is driven once more. Where the program is
/// interrupted: nothing. Throws std::runtime_error with the last words of a shard that fails twice.
std::vector<ResultsFile> drive_in_shards(const EvaluateOptions& options, std::size_t count,
                                         const Provenance& made, const std::filesystem::path& folder);

}  // namespace bw
