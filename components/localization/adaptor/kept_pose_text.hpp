// A kept pose as a line of text, for a keepsake (runtime/keepsake.hpp).
#pragma once

#include <optional>
#include <string>

#include "components/localization/kept_pose.hpp"

namespace bw::localization {

std::string to_text(const KeptPose& kept);
/// Nothing where the text is no pose with a positive variance of each coordinate.
std::optional<KeptPose> kept_pose(const std::string& text);

}  // namespace bw::localization
