// The robot's side of a Foxglove server on a DDS participant of its own: an outsider, as ros2's tools are. It
// shows any ROS 2 system whose types this program knows. What no client asks for is not heard; without
// clients it looks at discovery, and nothing else.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/foxglove/wire_clock.hpp"
#include "runtime/remote/foxglove/wire_link.hpp"
#include "runtime/remote/foxglove/wire_parameters.hpp"
#include "runtime/remote/foxglove/wire_publisher.hpp"
#include "runtime/remote/foxglove/wire_services.hpp"
#include "runtime/remote/foxglove/wire_topics.hpp"

namespace bw::foxglove {

struct WireRobotOptions {
  dds::Network network;
  std::string node = "viewer";                  ///< its name for ROS 2's tools, in the root namespace
  RosDistro distro = RosDistro::automatic;      ///< how it is announced
  bool looks_around = true;                     ///< for how others are announced; not in lock-step
  std::string refusal;                          ///< non-empty: nothing may be published, and that is why
  std::map<std::string, std::string> metadata;  ///< told beside ROS_DISTRO
};

class WireRobot final : public Robot {
 public:
  /// `post` brings work to the server's thread, on which all else is called, this and its end included. It
  /// may be called from any thread until then. Throws std::runtime_error as dds::Participant does.
  WireRobot(WireRobotOptions options, Post post);
  ~WireRobot() override;
  WireRobot(const WireRobot&) = delete;
  WireRobot& operator=(const WireRobot&) = delete;

  void set_listener(RobotListener* listener) override;
  void subscribe(std::uint32_t channel) override;
  void unsubscribe(std::uint32_t channel) override { topics_.unsubscribe(channel); }
  std::vector<std::pair<Time, SharedBytes>> latched(std::uint32_t channel) const override;
  std::optional<std::string> advertise(const std::string& topic, const std::string& type) override;
  void unadvertise(const std::string& topic) override;
  std::optional<std::string> publish(const std::string& topic, std::span<const std::uint8_t> cdr) override;
  std::optional<std::string> publish_json(const std::string& topic, std::string_view json) override;
  void call(std::uint32_t service, std::span<const std::uint8_t> cdr, Answer answer) override;
  void call_json(std::uint32_t service, std::string_view json, Answer answer) override;
  void get_parameters(const std::vector<std::string>& names, Values values) override;
  void set_parameters(const std::vector<NamedValue>& parameters, Values values) override;
  ConnectionGraph graph() const override { return graph_; }
  std::map<std::string, std::string> metadata() const override;

 private:
  void watch();
  void tick();
  void look();
  void update_is_busy();

  const WireRobotOptions options_;
  std::atomic<bool> has_names_ = true;  ///< to be read in `link_.directory`
  std::atomic<bool> is_busy_ = false;   ///< something needs tick()
  WireLink link_;
  WireClock clock_;
  WireTopics topics_;
  WireServices services_;
  WireParameters parameters_;
  WirePublisher publisher_;
  ConnectionGraph graph_;
  std::atomic<std::uint64_t> known_changes_ = ~std::uint64_t{0};
  PostedTask ticking_;

  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;  ///< guarded by mutex_
  std::thread thread_;
};

/// Who writes and hears what, and offers which service, by name of its node. Ends that no node has named are
/// left out.
[[nodiscard]] ConnectionGraph connection_graph(const std::vector<dds::Endpoint>& endpoints,
                                               const NodeDirectory& nodes);

}  // namespace bw::foxglove
