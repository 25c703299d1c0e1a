// A drive among walkers as pictures want it.
#pragma once

#include "components/evaluation/run_recorder.hpp"
#include "components/lab/bench/crowd_episode.hpp"

namespace bw {

/// Drives with a new planner, a moment every control period.
RunRecording record_crowd(const Scene& scene, const SceneFile& file, LocalPlanner& planner);

}  // namespace bw
