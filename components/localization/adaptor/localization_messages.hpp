// From estimates to what others read. For the adaptor only.
#pragma once

#include <string>

#include <geometry_msgs/msg/pose_array.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <nav2_msgs/msg/particle_cloud.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/localization/estimate.hpp"
#include "components/localization/health.hpp"
#include "components/localization/particle_filter/particle_set.hpp"
#include "components/localization/source_names.hpp"
#include "runtime/component.hpp"

namespace bw::localization {

nav_msgs::msg::Odometry to_odometry(const Estimate& estimate, const std::string& map_frame,
                                    const std::string& base_frame);
geometry_msgs::msg::PoseWithCovarianceStamped to_pose_message(const Estimate& estimate,
                                                              const std::string& map_frame);

/// At most `most` particles, evenly taken. nav2_msgs for Nav2's rviz2 plugin; PoseArray for everybody else.
nav2_msgs::msg::ParticleCloud to_cloud(const ParticleSet& particles, const std_msgs::msg::Header& header,
                                       std::size_t most);
geometry_msgs::msg::PoseArray to_poses(const ParticleSet& particles, const std_msgs::msg::Header& header,
                                       std::size_t most);

/// One line: "DEGRADED: source silent (gps, 3.2)".
std::string to_text(const Health& health, const SourceNames& names);
/// The state as level and text, each source's figures as values.
void report(const Health& health, const Estimate& estimate, const SourceNames& names,
            DiagnosticReporter& diagnostics);

}  // namespace bw::localization
