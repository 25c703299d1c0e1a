// How ROS 2 spells topics, types and type hashes on DDS.
#pragma once

#include <string>

namespace bw {

/// rt/odom -> /odom; other names unchanged.
[[nodiscard]] std::string ros_topic(const std::string& dds_topic);
/// /odom -> rt/odom
[[nodiscard]] std::string dds_topic(const std::string& ros_topic);

/// The two DDS topics of a ROS service: /a/s -> rq/a/sRequest, rr/a/sReply
[[nodiscard]] std::string request_topic(const std::string& service);
[[nodiscard]] std::string reply_topic(const std::string& service);
/// rq/a/sRequest -> /a/s; empty for other names.
[[nodiscard]] std::string service_of_request(const std::string& dds_topic);

/// nav_msgs::msg::dds_::Odometry_ -> nav_msgs/msg/Odometry; other names unchanged.
[[nodiscard]] std::string ros_type(const std::string& dds_type);
/// nav_msgs/msg/Odometry -> nav_msgs::msg::dds_::Odometry_; other names unchanged.
[[nodiscard]] std::string dds_type(const std::string& ros_type);

/// The RIHS01_... in an endpoint's user data; empty where there is none (Humble).
[[nodiscard]] std::string type_hash_in(const std::string& user_data);
/// The user data that tells it; empty for an empty hash.
[[nodiscard]] std::string user_data_of(const std::string& type_hash);

}  // namespace bw
