// The type-erased ends of topics, services and actions: what the templates of component.hpp hand to the host,
// which alone knows lanes, clocks and DDS.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/goal_status.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Whether the inputs a component declared essential (graph: max_age, on_stale) are fresh.
enum class Health { ok, degraded, stop };

/// Who wrote the sample that a callback of an input gets.
struct SampleOrigin {
  std::array<std::uint8_t, 16> writer{};  ///< its GID; zeros in callbacks that are of no input
  bool is_own_clock = true;               ///< it writes on this host, so its stamps are of the same clock
};

/// The writers of the topics that a component hears, by their GID.
class Writers {
 public:
  virtual ~Writers() = default;
  /// Full name of its node, /robot1/panel; empty: nobody has named it, or not yet.
  virtual std::string node_of(const std::array<std::uint8_t, 16>& writer) = 0;
  /// For how long it counts as there when its process is killed: its lease in DDS, 0 in this process;
  /// nothing: it has left.
  virtual std::optional<Duration> lease_of(const std::array<std::uint8_t, 16>& writer) = 0;
};

/// One call of a component: the frozen time and the state of its inputs. No other clock may be read.
struct Tick {
  Time now;
  Health health = Health::ok;  ///< stop: bring the robot to a safe stop in this very call
  std::uint64_t sequence = 0;  ///< counts the calls of this callback from 0
  SampleOrigin from;
};

/// Names of a message type as the wire knows them.
struct MessageType {
  std::string_view ros_name;   ///< nav_msgs/msg/Odometry
  std::string_view dds_name;   ///< nav_msgs::msg::dds_::Odometry_
  std::string_view type_hash;  ///< RIHS01_...
};

/// Whether a graph is refused in which nobody publishes the input, or offers the service.
enum class Need { required, optional };

class OutputPort {
 public:
  virtual ~OutputPort() = default;
  virtual void publish(std::span<const std::uint8_t> cdr) = 0;
  /// Somebody listens; a costly message may be skipped when nobody does. Always true in lock-step, so that
  /// runs stay equal.
  virtual bool has_readers() const = 0;
  std::vector<std::uint8_t> buffer;  ///< reused by Output::publish
};

/// Gives the bytes of one sample to the component; false when they do not hold the message. No bytes at all:
/// what is kept of earlier ones is out of date.
using SampleHandler = std::function<bool(std::span<const std::uint8_t> cdr, const Tick& tick)>;
using TickHandler = std::function<void(const Tick& tick)>;

/// Names of a service type as the wire knows them.
struct ServiceType {
  std::string_view ros_name;  ///< rcl_interfaces/srv/GetParameters
  MessageType request;
  MessageType response;
  MessageType event;  ///< both in one message: the form in which a request is recorded
};

/// Whom a reply goes to: the client, and its count of the request.
struct RequestId {
  std::array<std::uint8_t, 16> client{};
  std::int64_t sequence = 0;
  auto operator<=>(const RequestId&) const = default;
};

class ServicePort {
 public:
  virtual ~ServicePort() = default;
  virtual void reply(const RequestId& to, std::span<const std::uint8_t> cdr) = 0;
};

/// What a service does with a request. A service that changes something says with `refuse` what it answers
/// where that may not be; without, it only tells.
struct RequestHandler {
  /// False when the bytes do not hold the request.
  std::function<bool(std::span<const std::uint8_t> cdr, const RequestId& from, const Tick& tick)> handle;
  std::function<void(const std::string& reason, std::vector<std::uint8_t>& cdr)> refuse = nullptr;
  /// The response with nothing in it: what is answered where there is no component to tell.
  std::function<void(std::vector<std::uint8_t>& cdr)> empty = nullptr;
  /// With `refuse`: the request as a message that can be recorded, and back. False when the bytes do not hold
  /// it.
  std::function<bool(std::span<const std::uint8_t> request, const RequestId& from, Time now,
                     std::vector<std::uint8_t>& event)>
      to_event = nullptr;
  std::function<bool(std::span<const std::uint8_t> event, RequestId& from,
                     std::vector<std::uint8_t>& request)>
      from_event = nullptr;
};

/// Whether a service is answered while its component is not active.
enum class ServiceScope { component, node };

/// The reply, or nothing when none came in time.
using ReplyHandler = std::function<void(std::optional<std::span<const std::uint8_t>> cdr, const Tick& tick)>;

/// Which goal of an action it is: a UUID that its client makes up.
using GoalId = std::array<std::uint8_t, 16>;

/// Names of an action type as the wire knows them.
struct ActionType {
  std::string_view ros_name;  ///< nav2_msgs/action/NavigateToPose
  ServiceType send_goal;
  ServiceType cancel_goal;
  ServiceType get_result;
  MessageType feedback;
  MessageType status;
};

/// Which goals a request to cancel means, and what became of it: action_msgs/srv/CancelGoal.
struct CancelRequest {
  GoalId id{};
  Time stamp;
};
struct CanceledGoals {
  struct Goal {
    GoalId id{};
    Time accepted;
  };
  std::uint8_t code = 0;
  std::vector<Goal> goals;
};

/// The goals of one action server. What the wire asks comes on a lane of its own, so that a busy component
/// delays no answer; what the component says counts when its callback is over.
class ActionPort {
 public:
  virtual ~ActionPort() = default;

  // The wire's side.
  virtual ServicePort& send_goal_port() = 0;
  virtual ServicePort& cancel_goal_port() = 0;
  virtual ServicePort& get_result_port() = 0;
  /// Whether the goal is accepted: then the component hears of it, and `goal` is kept until it ends.
  virtual bool offer(const GoalId& id, std::shared_ptr<const void> goal, Time now) = 0;
  virtual CanceledGoals cancel(const CancelRequest& request, Time now) = 0;
  /// The response to get_result, as soon as the goal has ended.
  virtual void send_result(const GoalId& id, const RequestId& to, Time now) = 0;

  // The component's side.
  virtual bool is_open(const GoalId& id) const = 0;
  virtual bool is_canceling(const GoalId& id) const = 0;
  virtual void execute(const GoalId& id) = 0;
  virtual void feedback(const GoalId& id, std::span<const std::uint8_t> cdr) = 0;
  /// `result` is the whole response to get_result.
  virtual void finish(const GoalId& id, GoalStatus end, std::vector<std::uint8_t> result) = 0;
};

/// What an action server does. The first four outlive the component: nothing of it is captured in them.
struct ActionHandler {
  RequestHandler send_goal;
  RequestHandler cancel_goal;
  RequestHandler get_result;
  /// The whole response to get_result about a goal that the component did not end; about none with status
  /// unknown.
  std::function<std::vector<std::uint8_t>(GoalStatus status, const std::string& reason)> abandoned;
  std::function<void(const GoalId& id, std::shared_ptr<const void> goal, const Tick& tick)> on_goal;
  std::function<void(const GoalId& id, std::shared_ptr<const void> goal, const Tick& tick)> on_cancel;
};

class ClientPort {
 public:
  virtual ~ClientPort() = default;
  virtual bool is_ready() const = 0;
  virtual void call(std::span<const std::uint8_t> cdr, Duration deadline, ReplyHandler on_reply) = 0;
};

}  // namespace bw
