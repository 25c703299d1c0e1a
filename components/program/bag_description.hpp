// What the bags of a drive carry beside its messages.
#pragma once

#include "runtime/host/host.hpp"
#include "runtime/recording/bag/flight_recorder.hpp"

namespace bw {

/// Attachments graph.yaml, parameters.yaml and one file for each shared section that has one, such as
/// robot.yaml; metadata `bandwagon`.
[[nodiscard]] bag::BagDescription describe(const Host& host, const HostOptions& options);

/// Whose layouts its messages have: as the graph says, or as the environment does.
[[nodiscard]] std::string ros_distro_of(const Graph& graph);

}  // namespace bw
