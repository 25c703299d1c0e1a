#include "components/localization/adaptor/localization_messages.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/messages/geometry.hpp"

namespace bw::localization {
namespace {

template <class Visit>
void every_nth(std::size_t count, std::size_t most, Visit visit) {
  const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
  for (std::size_t i = 0; i < count; i += step) visit(i);
}

}  // namespace

nav_msgs::msg::Odometry to_odometry(const Estimate& estimate, const std::string& map_frame,
                                    const std::string& base_frame) {
  nav_msgs::msg::Odometry message;
  message.header(make_header(map_frame, estimate.time));
  message.child_frame_id(base_frame);
  message.pose().pose(to_pose(estimate.X_MB));
  set_planar_covariance(message.pose().covariance(), estimate.covariance);
  message.twist().twist(to_twist_message(estimate.twist));
  return message;
}

geometry_msgs::msg::PoseWithCovarianceStamped to_pose_message(const Estimate& estimate,
                                                              const std::string& map_frame) {
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  message.header(make_header(map_frame, estimate.time));
  message.pose().pose(to_pose(estimate.X_MB));
  set_planar_covariance(message.pose().covariance(), estimate.covariance);
  return message;
}

nav2_msgs::msg::ParticleCloud to_cloud(const ParticleSet& particles, const std_msgs::msg::Header& header,
                                       std::size_t most) {
  nav2_msgs::msg::ParticleCloud message;
  message.header(header);
  every_nth(particles.size(), most, [&](std::size_t i) {
    nav2_msgs::msg::Particle particle;
    particle.pose(to_pose({particles.x[i], particles.y[i], particles.theta[i]}));
    particle.weight(particles.weight[i]);
    message.particles().push_back(particle);
  });
  return message;
}

geometry_msgs::msg::PoseArray to_poses(const ParticleSet& particles, const std_msgs::msg::Header& header,
                                       std::size_t most) {
  geometry_msgs::msg::PoseArray message;
  message.header(header);
  every_nth(particles.size(), most, [&](std::size_t i) {
    message.poses().push_back(to_pose({particles.x[i], particles.y[i], particles.theta[i]}));
  });
  return message;
}

std::string to_text(const Health& health, const SourceNames& names) {
  std::string text(to_string(health.state));
  for (const HealthReason& reason : health.reasons) {
    text += fmt::format("{} {}", &reason == &health.reasons.front() ? ":" : ";", to_string(reason.cause));
    if (reason.source >= 0) {
      text += fmt::format(" ({}, {:.2f})", names.of(reason.source), reason.value);
    } else if (reason.value != 0.0) {
      text += fmt::format(" ({:.2f})", reason.value);
    }
  }
  return text;
}

void report(const Health& health, const Estimate& estimate, const SourceNames& names,
            DiagnosticReporter& diagnostics) {
  using Level = DiagnosticReporter::Level;
  const Level level = health.state == HealthState::ok     ? Level::ok
                      : health.state == HealthState::lost ? Level::error
                                                          : Level::warn;
  diagnostics.report(level, to_text(health, names));
  diagnostics.set_value("state", std::string(to_string(health.state)));
  for (const SourceHealth& source : health.sources) {
    const std::string name = names.of(source.source);
    diagnostics.set_value(
        name, fmt::format("age {:.2f} s, period {:.3f} s, used {}, rejected {}, acceptance {:.2f}",
                          source.age, source.period, source.used, source.rejected, source.acceptance));
    if (source.dof > 0) {
      diagnostics.set_value(name + " nis", fmt::format("{:.2f} of those used, {:.2f} of all; {} expected",
                                                       source.nis, source.nis_all, source.dof));
    }
  }
  if (health.state == HealthState::init) return;
  const Vector2 axes = ellipse_95(estimate.covariance.topLeftCorner<2, 2>());
  diagnostics.set_value("ellipse_95", fmt::format("{:.3f} x {:.3f} m", axes.x(), axes.y()));
  diagnostics.set_value("heading_sigma", fmt::format("{:.4f} rad", health.heading_sigma));
}

}  // namespace bw::localization
