// Quality of service as rosbag2 writes it into bags: YAML, a list of one profile for each publisher. Written
// with numbers, which every reader since Humble understands; read with numbers or with words (Jazzy).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/graph/qos.hpp"

namespace bw::bag {

/// A depth of 0 is one that nobody told, as of writers that only discovery knows.
[[nodiscard]] std::string to_qos_text(const std::vector<Qos>& offered);

/// Empty for text that is none: a bag is played with the default profile then. Only what Qos holds is read.
[[nodiscard]] std::vector<Qos> from_qos_text(const std::string& text);

/// What a player offers for a topic recorded from `offered`: the profile all agree on, else the default. Its
/// depth is at least 10.
[[nodiscard]] Qos playing_qos(const std::vector<Qos>& offered);

}  // namespace bw::bag
