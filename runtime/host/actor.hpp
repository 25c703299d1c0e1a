// One component at run time: its ends, its timers, and the one way its callbacks are entered.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/component.hpp"
#include "runtime/dds/participant.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/action_end.hpp"
#include "runtime/host/actor_lifecycle.hpp"
#include "runtime/host/client_end.hpp"
#include "runtime/host/input_endpoint.hpp"
#include "runtime/host/service_end.hpp"
#include "runtime/host/statistics.hpp"
#include "runtime/host/timer.hpp"
#include "runtime/lifecycle/state_machine.hpp"

namespace bw {

struct Actor;
class NestedLifecycle;

class Input final : public InputEndpoint {
 public:
  const std::string& label() const override { return topic; }
  bool calls_component() const override;
  bool take_one(Time now, std::optional<Duration> waited) override;

  std::string name;   ///< as the component declared it
  std::string topic;  ///< resolved, absolute
  MessageType type;
  Qos qos;
  SampleHandler handler;
  InputKind kind = InputKind::callback;
  Need need = Need::required;
  bool is_external = false;  ///< the graph leaves the topic to others
  std::string commander;     ///< full name of the node whose command this is; empty: anybody may write it
  std::optional<Duration> max_age;
  OnStale on_stale = OnStale::ignore;
  std::unique_ptr<dds::Reader> reader;
  Time last_received;  ///< activation time until the first sample
  bool of_node =
      false;  ///< the runtime's, or of the part that outlives instances: heard in every state of the component
  bool is_declared =
      true;  ///< of the component and its part; a second end of the part on one topic is an ear more, and no input

  /// Samples of a latched topic outlive the instance that heard them: the next one does not get them from the
  /// wire again.
  struct Kept {
    dds::Guid writer;
    std::vector<std::uint8_t> cdr;
    bool is_given = false;  ///< to the instance there is
  };
  std::deque<Kept> kept;  ///< as many of each writer as the topic keeps
  void keep(const dds::Sample& sample, bool is_given);

  /// Of a command: another writer than this one has commanded within the last second, and is there still.
  bool has_rival(const dds::Guid& writer, Time now);
  struct Heard {
    dds::Guid writer{};
    Time at;
  };
  std::optional<Heard> last_heard, rival;
  std::atomic<std::uint64_t> refused = 0;  ///< commands that were not obeyed because of a rival
  std::uint64_t calls = 0;
  CallbackStatistics statistics;
};

/// Where an actor's outputs go: straight to DDS, or held back for the declared latency.
class SampleSink {
 public:
  virtual ~SampleSink() = default;
  virtual void publish(class OutputEnd& output, std::span<const std::uint8_t> cdr) = 0;
  /// Does it when the callback that runs has taken its declared latency, at once without one.
  virtual void when_done(std::function<void()> action) = 0;
};

/// Stands between an actor and the wire: what goes wrong on purpose.
class OutputGate {
 public:
  virtual ~OutputGate() = default;
  /// Publishes to the output's sink what becomes of it, now or later or never.
  virtual void pass(class OutputEnd& output, std::span<const std::uint8_t> cdr) = 0;
};

class OutputEnd final : public OutputPort {
 public:
  OutputEnd(Actor& actor, std::string topic_name, const MessageType& message_type, const Qos& topic_qos,
            bool is_command)
      : owner(actor), topic(std::move(topic_name)), type(message_type), qos(topic_qos), command(is_command) {}
  void publish(std::span<const std::uint8_t> cdr) override {
    if (sink == nullptr) return;
    if (gate != nullptr) {
      gate->pass(*this, cdr);
    } else {
      sink->publish(*this, cdr);
    }
  }
  bool has_readers() const override { return always_read || (writer && writer->matched_readers() > 0); }

  Actor& owner;
  std::string name;
  std::string topic;
  MessageType type;
  Qos qos;
  bool command;
  bool always_read = false;
  bool of_node = false;  ///< the runtime's: it is never mute
  std::unique_ptr<dds::Writer> writer;
  SampleSink* sink = nullptr;  ///< null until the component is active
  OutputGate* gate = nullptr;  ///< null: nothing is wrong with it
};

/// What an actor is to the host.
enum class ActorRole {
  process,    ///< what every process offers
  component,  ///< of the graph: it has a lifecycle of its own
  observer,   ///< of the program: up from the beginning to the end
  manager,    ///< brings components up and down
};

struct Actor final : DiagnosticReporter {
  Actor();
  ~Actor() override;
  ActorRole role = ActorRole::component;
  std::atomic<lifecycle::State> state = lifecycle::State::inactive;  ///< changed on its lane only
  std::atomic<std::uint64_t> activations = 0;
  std::unique_ptr<ActorLifecycle> lifecycle;
  std::unique_ptr<NestedLifecycle> led;  ///< those that follow this one's states; null: nobody does
  bool is_led = false;                   ///< it follows another's
  std::string name;                      ///< in the graph
  std::string node_name;                 ///< on the wire
  std::string node_namespace;            ///< "/" or "/robot1"
  std::string type;
  std::string process;
  std::string lane;
  bool is_real_time = false;  ///< its lane comes before others
  std::size_t rank = 0;
  Duration latency;
  std::function<Duration(Time)> clock_error;        ///< by how much its clock is wrong; empty: it is not
  Duration longest_callback;                        ///< by its own word; zero: short
  const class WriterClock* writer_clock = nullptr;  ///< null: there is one clock
  class CommandedMotion* motion = nullptr;          ///< sees the commands that it obeys; null: nobody does
  std::shared_ptr<void> part;  ///< of the component, and outlives its instances; null: it has none
  std::unique_ptr<Component> component;
  std::vector<std::unique_ptr<Input>> inputs;
  std::vector<const Input*> watched;  ///< inputs with a max_age
  std::vector<std::unique_ptr<OutputEnd>> outputs;
  std::vector<std::unique_ptr<Timer>> timers;
  std::vector<std::unique_ptr<ServiceEnd>> services;
  std::vector<std::unique_ptr<ActionEnd>> actions;
  std::vector<std::unique_ptr<ClientEnd>> clients;
  struct DeclaredFailsafe {
    FailsafeRow row;
    std::atomic<bool> in_force = false;
  };
  std::deque<DeclaredFailsafe> failsafes;  ///< a deque: handles point into it
  ParameterReport parameters;
  std::map<std::string, ParameterReport> shared_parameters;  ///< by section, as it read them
  LiveParameters live_parameters;
  std::function<void(const Input&)> on_first_rejected;  ///< an input's sample is not its message

  /// Guards what the diagnostics read while the lane works: statistics, arrival times, the three below.
  mutable std::mutex mutex;
  Level diagnostic_level = Level::ok;
  std::string diagnostic_message = "ok";
  std::map<std::string, std::string> diagnostic_values;
  std::atomic<bool> stop_requested =
      false;  ///< the host is shutting down: Health::stop whatever the inputs say

  void report(Level level, std::string message) override {
    const std::lock_guard lock(mutex);
    diagnostic_level = level;
    diagnostic_message = std::move(message);
  }
  void set_value(const std::string& key, std::string value) override {
    const std::lock_guard lock(mutex);
    diagnostic_values[key] = std::move(value);
  }
  /// What its clock says at `now`, of the run.
  Time own_time(Time now) const { return clock_error ? now + clock_error(now) : now; }
  /// From the ages of the watched inputs at `now`, of its own clock.
  Health health(Time now) const;
  /// Names of the watched inputs that are too old at `now`. With `mutex` held.
  std::vector<std::string> stale_inputs(Time now) const;

  bool is_in_graph() const { return role == ActorRole::component || role == ActorRole::observer; }
  /// The component declared no end: it looks on from outside, as the viewer does.
  bool is_onlooker() const;
  bool is_active() const { return state == lifecycle::State::active; }
  bool runs(const Timer& timer) const { return timer.of_node || is_active(); }
  /// "planner is not active (unconfigured)"
  std::string not_active() const;

  /// Takes one sample and gives it to the component; false when none was waiting.
  bool deliver(Input& input, Time now, std::optional<Duration> waited);
  /// Gives the bytes of one sample to the component.
  void give(Input& input, const dds::Guid& writer, std::span<const std::uint8_t> cdr, Time now,
            std::optional<Duration> waited = std::nullopt);
  void fire(Timer& timer, Time now, std::optional<Duration> waited);

 private:
  /// Ages count from here after a clock that went back, or a silent input would stay fresh until it is there
  /// again.
  void see(Time now);

  dds::Sample sample_;
  Time now_;
};

}  // namespace bw
