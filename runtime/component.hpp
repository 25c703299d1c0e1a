// What a component is, and how it declares its ends. A component is an actor: its callbacks never run at the
// same time.
//
//   class Doubler final : public bw::Component {
//     void configure(bw::Setup& setup) override {
//       out_ = setup.output<std_msgs::msg::Float64>("doubled");
//       setup.input<std_msgs::msg::Float64>("value", bw::Qos::standard(),
//                                           [this](const auto& message, const bw::Tick&) { ... });
//     }
//     bw::Output<std_msgs::msg::Float64> out_;
//   };
//   BW_COMPONENT(Doubler, "doubler")
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/action.hpp"
#include "runtime/action_client.hpp"
#include "runtime/base/ros_distro.hpp"
#include "runtime/base/time.hpp"
#include "runtime/failsafe.hpp"
#include "runtime/graph/qos.hpp"
#include "runtime/keepsake.hpp"
#include "runtime/live_parameters.hpp"
#include "runtime/logger.hpp"
#include "runtime/parameters/list_parameters.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/write_parameters.hpp"
#include "runtime/ports.hpp"
#include "runtime/service.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {

class TransformTree;
namespace dds {
struct Network;
}

/// Writes messages to a topic. A copyable handle; valid from configure() on, writes only while the component
/// is active.
template <class M>
class Output {
 public:
  Output() = default;
  explicit Output(OutputPort* port) : port_(port) {}

  void publish(const M& message) const {
    serialize(message, port_->buffer);
    port_->publish(port_->buffer);
  }
  bool has_readers() const { return port_->has_readers(); }

 private:
  OutputPort* port_ = nullptr;
};

/// The newest message of a topic; empty until the first one since activation came, unless the topic is
/// latched.
template <class M>
class Latest {
 public:
  explicit operator bool() const { return state_ && state_->message.has_value(); }
  const M& operator*() const { return *state_->message; }
  const M* operator->() const { return &*state_->message; }
  /// When it came, on the component clock.
  Time received() const { return state_->received; }

 private:
  friend class Setup;
  struct State {
    std::optional<M> message;
    Time received;
  };
  std::shared_ptr<State> state_;
};

/// The parameters of an instance as people read them.
struct ParameterReport {
  std::vector<ParameterRow> rows;
  std::string yaml;                ///< reads back to the same values
  std::vector<std::string> names;  ///< all that can be set (parameter_names)
};

template <HasFields P>
ParameterReport report_of(P& values, P defaults) {
  ParameterReport report{.rows = list_parameters(FieldRef::of(values), FieldRef::of(defaults), ""),
                         .yaml = to_yaml(values),
                         .names = {}};
  report.names = parameter_names(FieldRef::of(defaults));
  return report;
}

/// What the diagnostics topic says of a component, republished every second.
class DiagnosticReporter {
 public:
  enum class Level : std::uint8_t { ok = 0, warn = 1, error = 2 };
  virtual ~DiagnosticReporter() = default;
  virtual void report(Level level, std::string message) = 0;
  /// A figure beside the message, kept until it is set again. In lock-step nothing measured on a real clock.
  virtual void set_value(const std::string& key, std::string value) = 0;
};

/// Whether a message calls the component, or only waits to be looked at.
enum class InputKind { callback, keep_newest };

/// Handed to configure(): the place where a component declares everything it will use.
class Setup {
 public:
  virtual ~Setup() = default;

  /// The parameters of this instance, read strictly from the graph over the defaults of P. While the
  /// component is configured, they may be changed from outside if it wants to hear of it: `on_change` gets
  /// every new snapshot between two callbacks, whole and checked; a std::runtime_error of it refuses the
  /// change, and it gets the old one again. `fixed` names parameters, or sections of them, that may not be
  /// changed even so; without `on_change` none may.
  template <class P>
  P parameters(std::function<void(const P&, const Tick&)> on_change = {},
               std::vector<std::string> fixed = {}) {
    P values;
    OnParameters on_snapshot;
    if (on_change)
      on_snapshot = [on_change = std::move(on_change)](const ParameterSet& snapshot, const Tick& tick) {
        on_change(snapshot.as<P>(), tick);
      };
    declare_parameters(values, std::move(on_snapshot), std::move(fixed));
    return values;
  }
  /// A section of the graph that components share, or by a dot one within it: "robot.base"; `values` are the
  /// defaults. What it describes may move, and then says by a member `Duration time_to_rest() const` how long
  /// the run goes on after an end that finds it moving.
  template <class S>
  S shared(std::string_view section, S values = {}) {
    const S defaults = values;
    read_into(values, shared_section(section), section);
    keep_shared_parameters(section, report_of(values, defaults), ParameterSet(values));
    if constexpr (requires { values.time_to_rest(); }) comes_to_rest_within(section, values.time_to_rest());
    return values;
  }
  /// The file a text parameter names, relative to the YAML that says so. Empty path when the text is empty.
  virtual std::filesystem::path file_parameter(std::string_view key) const = 0;

  template <class M>
  Output<M> output(const std::string& topic, const Qos& qos = Qos::standard()) {
    return Output<M>(add_output(topic, message_type<M>(), qos, false));
  }
  /// An output whose messages are bytes already: CDR with its encapsulation, passed through as they are.
  /// `type` must outlive the run.
  OutputPort* raw_output(const std::string& topic, const MessageType& type, const Qos& qos) {
    return add_output(topic, type, qos, false);
  }
  /// An output that moves something: one publisher in the whole graph, checked.
  template <class M>
  Output<M> command(const std::string& topic) {
    return Output<M>(add_output(topic, message_type<M>(), Qos::command(), true));
  }
  /// Calls `on_message` for every message.
  template <class M, class Callback>
  void input(const std::string& topic, const Qos& qos, Callback on_message, Need need = Need::required) {
    auto message = std::make_shared<M>();  // kept, so that its buffers are reused
    add_input(topic, message_type<M>(), qos, InputKind::callback, need,
              [message, callback = std::move(on_message)](std::span<const std::uint8_t> cdr,
                                                          const Tick& tick) mutable {
                if (!deserialize(cdr, *message)) return false;
                callback(std::as_const(*message), tick);
                return true;
              });
  }
  /// Keeps the newest message; calls nothing and costs the component no latency.
  template <class M>
  Latest<M> latest(const std::string& topic, const Qos& qos, Need need = Need::required) {
    Latest<M> handle;
    handle.state_ = std::make_shared<typename Latest<M>::State>();
    auto incoming = std::make_shared<M>();
    add_input(topic, message_type<M>(), qos, InputKind::keep_newest, need,
              [state = handle.state_, incoming](std::span<const std::uint8_t> cdr, const Tick& tick) mutable {
                if (cdr.empty()) state->message.reset();
                if (!deserialize(cdr, *incoming)) return false;
                if (!state->message) state->message.emplace();
                std::swap(*state->message, *incoming);
                state->received = tick.now;
                return true;
              });
    return handle;
  }
  /// Calls `on_tick` every `period`, first at one period after activation. Ticks missed while busy become
  /// one.
  virtual void every(Duration period, const std::string& name, TickHandler on_tick) = 0;

  /// Answers requests of service S: `handle(request, tick)` returns the response, or `handle(request, reply,
  /// tick)` calls `reply` now or later. A service that changes something gives `refuse(reason)`, its answer
  /// where that may not be: the component is not active, the run is in lock-step, the request cannot be read.
  /// Without it the service only tells.
  template <class S, class Handle>
  void service(const std::string& name, Handle handle, Refusal<S> refuse = nullptr,
               ServiceScope scope = ServiceScope::component) {
    ServicePort& port = add_service(name, service_type<S>(), scope);
    set_handler(port, request_handler<S>(port, std::move(handle), std::move(refuse)));
  }
  template <class S>
  Client<S> client(const std::string& name, Need need = Need::required) {
    return Client<S>(add_client(name, service_type<S>(), need));
  }

  /// Serves action A.
  template <class A>
  void action(const std::string& name, ActionCallbacks<A> callbacks) {
    ActionPort& port = add_action(name, action_type<A>());
    set_action(port, action_handler<A>(port, std::move(callbacks)));
  }
  template <class A>
  ActionClient<A> action_client(const std::string& name, Need need = Need::required) {
    return ActionClient<A>::declare(*this, name, need);
  }

  /// What outlives the instance, and with it a cleanup and every later configure: made with the node, the
  /// same from then on. What it declares in its own `configure(Setup&)` is heard in every state of the
  /// component. One for each component.
  template <class Part>
  std::shared_ptr<Part> part_of_node() {
    return std::static_pointer_cast<Part>(keep_part([](Setup& setup) {
      auto part = std::make_shared<Part>();
      part->configure(setup);
      return part;
    }));
  }
  /// A file that outlives the process, below the user's state folder, for this node on this domain alone. Not
  /// in lock-step: what a run leaves decides nothing of the next one. Throws std::runtime_error where the
  /// environment names no folder.
  virtual std::filesystem::path state_file(const std::string& name) const = 0;
  /// What the component before this one left, where its process was killed and started again. Never in lock-step.
  virtual Keepsake keepsake(const std::string& name) const = 0;
  /// Who writes what this component hears. Valid as long as the host.
  virtual Writers& writers() = 0;

  /// A transform tree fed from /tf and /tf_static.
  std::shared_ptr<const TransformTree> transforms();
  /// `name` with the frame prefix of the robot; `map` has none.
  virtual std::string frame(std::string_view name) const = 0;
  /// A seed for this component's random numbers: the run's seed mixed with the instance name.
  virtual std::uint64_t seed() const = 0;
  /// Time is virtual: no thread of one's own, and nothing measured on a real clock decides anything.
  virtual bool is_lockstep() const = 0;
  /// Lock-step: what changes something may come from outside (--accept-inputs). True on every other clock.
  virtual bool accepts_inputs() const = 0;
  /// How long a callback of this component may take at worst, where that is more than half a second: files, searches.
  /// A lane that takes longer is a hang, and its process is ended by who started it (host/lane_watch.hpp).
  virtual void longest_callback(Duration time) = 0;
  /// For a component that looks at the run as other programs do: the network to join
  /// (runtime/dds/participant.hpp).
  virtual dds::Network network() const = 0;
  /// Whose bytes nav2_msgs has on the wire; never `automatic`: where nobody says, Jazzy's.
  virtual RosDistro ros_distro() const = 0;
  virtual Logger log() = 0;
  virtual DiagnosticReporter& diagnostics() = 0;
  /// A row of the failsafe table; the handle says when it is in force.
  virtual Failsafe failsafe(FailsafeRow row) = 0;
  /// Ends the run; scripts see exit status 0 when `ok`, 1 otherwise. Callable from callbacks.
  virtual std::function<void(bool ok, const std::string& reason)> finish_run() = 0;

 protected:
  template <class M>
  static MessageType message_type() {
    return {MessageTraits<M>::ros_name, MessageTraits<M>::dds_name, MessageTraits<M>::type_hash};
  }
  template <class P>
  void declare_parameters(P& values, OnParameters on_change, std::vector<std::string> fixed) {
    read_into(values, parameter_section(), parameter_path());
    keep_parameters(report_of(values, P{}), {ParameterSet(values), std::move(on_change), std::move(fixed)});
  }

  virtual std::shared_ptr<void> keep_part(std::function<std::shared_ptr<void>(Setup&)> make) = 0;
  virtual OutputPort* add_output(const std::string& topic, const MessageType& type, const Qos& qos,
                                 bool command) = 0;
  virtual void add_input(const std::string& topic, const MessageType& type, const Qos& qos, InputKind kind,
                         Need need, SampleHandler handler) = 0;
  virtual ServicePort& add_service(const std::string& name, const ServiceType& type, ServiceScope scope) = 0;
  virtual void set_handler(ServicePort& port, RequestHandler handler) = 0;
  virtual ActionPort& add_action(const std::string& name, const ActionType& type) = 0;
  virtual void set_action(ActionPort& port, ActionHandler handler) = 0;
  virtual ClientPort* add_client(const std::string& name, const ServiceType& type, Need need) = 0;
  virtual const ConfigNode& parameter_section() const = 0;
  virtual std::string parameter_path() const = 0;
  virtual const ConfigNode& shared_section(std::string_view section) const = 0;
  virtual void comes_to_rest_within(std::string_view section, Duration time) = 0;
  virtual void keep_parameters(ParameterReport report, ParameterDeclaration declaration) = 0;
  virtual void keep_shared_parameters(std::string_view section, ParameterReport report,
                                      ParameterSet values) = 0;
};

class Component {
 public:
  virtual ~Component() = default;
  /// Reads parameters and declares ends. Throws ConfigError or std::runtime_error; moves nothing, opens no
  /// device.
  virtual void configure(Setup& setup) = 0;
  /// The graph is connected; from now on callbacks run.
  virtual void activate(const Tick&) {}
  /// The last call that may publish; a component that moves something leaves it at rest.
  virtual void deactivate(const Tick&) {}
  virtual void cleanup() {}
};

using ComponentFactory = std::function<std::unique_ptr<Component>()>;

/// Makes a component type known by name. Throws std::logic_error when the name is taken.
bool register_component(const std::string& type_name, ComponentFactory factory);

}  // namespace bw

/// Once per component, in its source file.
#define BW_COMPONENT(Class, type_name)                                               \
  namespace {                                                                        \
  [[maybe_unused]] const bool registered_##Class =                                   \
      ::bw::register_component(type_name, [] { return std::make_unique<Class>(); }); \
  }
