// The relations of a log, as the SLAM benchmark of Kümmerle et al. gives them.
#pragma once

#include <filesystem>
#include <vector>

#include "components/lab/bench/slam/relation_score.hpp"

namespace bw::slam {

/// Lines `t1 t2 x y z roll pitch yaw` [s, m, rad] with white space between; # begins a comment; compressed by
/// gzip or not. z, roll and pitch are those of a floor, and not used. Throws std::runtime_error naming the
/// file, and the line and column where one of them is wrong; a file without relations.
std::vector<Relation> read_relations(const std::filesystem::path& file);

}  // namespace bw::slam
