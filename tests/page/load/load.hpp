// Many clients of a running viewer: who gets how much of it, and how late.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

namespace bw::test {

struct LoadOptions {
  std::uint16_t port = 8765;
  int healthy = 80;              ///< read at once whatever comes
  int slow = 20;                 ///< read one byte a second
  int flapping = 10;             ///< open, subscribe and close, over and over
  double flaps_per_second = 50;  ///< of each of them
  double seconds = 60;           ///< that are looked at, from when all have subscribed
  std::vector<std::string> topics = {"/scan", "/tracks", "/local_plan", "/tf"};
  pid_t robot = 0;  ///< whose memory is looked at; 0: nobody's
};

struct TopicLoad {
  std::string topic;
  std::uint64_t published = 0;  ///< as a reader of our own on the domain counts them
  double worst_share = 0;       ///< of the updates, that the healthy client which got least of them received
  double mean_share = 0;
};

struct LoadResult {
  std::vector<TopicLoad> topics;
  std::uint64_t received = 0;  ///< by all healthy ones
  double delay_ms_p50 = 0;     ///< from a message's log time to its arrival at a healthy client
  double delay_ms_p99 = 0;
  double delay_ms_max = 0;
  int healthy_closed = 0;           ///< by the server
  std::uint64_t flaps = 0;          ///< connections that the flapping ones opened
  std::uint64_t flaps_refused = 0;  ///< by the server, as too many at once
  double memory_mb = 0;             ///< the robot's most, less what it had before
};

/// std::runtime_error when a topic is not offered or the server is gone. Uses the domain of ROS_DOMAIN_ID,
/// loopback only.
LoadResult put_load(const LoadOptions& options);

nlohmann::json to_json(const LoadResult& result);

}  // namespace bw::test
