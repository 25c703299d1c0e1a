// One process of a graph: configures every component, checks the whole, connects the ends, runs, and leaves
// everything at rest.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/graph/check_graph.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/actor.hpp"
#include "runtime/host/component_clock.hpp"
#include "runtime/host/event_source.hpp"
#include "runtime/host/outside_inputs.hpp"
#include "runtime/host/runner.hpp"
#include "runtime/host/sample_tap.hpp"
#include "runtime/host/service_manager.hpp"

namespace bw {

class HostSetup;

enum class ClockMode {
  wall,      ///< real time, one thread per lane
  lockstep,  ///< virtual time, one thread
  topic,     ///< time from /clock, as ROS 2's use_sim_time
};

struct HostOptions {
  ClockMode clock = ClockMode::wall;
  std::uint64_t seed = 1;
  std::string only_process;  ///< empty: all processes of the graph in this one
  double pace = 0.0;         ///< lock-step: virtual seconds per real second; 0 as fast as possible
  std::optional<Time> start = std::nullopt;  ///< lock-step: where virtual time begins
  EventSource* source = nullptr;             ///< lock-step: what happens besides the components
  /// Lock-step: nobody sees this run, and it sees nobody: for runs that are only measured, side by side.
  bool alone = false;
  /// Lock-step: what changes something may come from outside, and is a part of the run then. Else it is
  /// refused.
  bool accept_inputs = false;
  bool is_partial =
      false;  ///< a part of a graph, looked at and not run: inputs that nobody feeds are no mistake
  std::shared_ptr<SampleTap> tap = nullptr;  ///< sees every sample of this process
};

/// A component that is not in the graph file, such as a program's own observer of a run.
struct ExtraComponent {
  std::string name;
  std::unique_ptr<Component> component;
  std::string lane = "main";
  bool first = false;  ///< comes before the graph's components, else after them
  std::string node_namespace = "/";
};

class Host {
 public:
  /// Configures and checks everything; nothing is on the wire yet. Throws ConfigError or std::runtime_error.
  Host(Graph graph, HostOptions options, std::vector<ExtraComponent> extra = {});
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Connects, activates, runs to the end, deactivates. Once.
  RunEnd run(std::optional<Duration> duration);
  /// Ends the run from any thread, and at any time: one that was not begun ends as soon as it is. With
  /// `at_rest` false what moves gets the time to stop that it asked for (Setup::shared).
  void finish(RunEnd end, bool at_rest);

  const Graph& graph() const { return graph_; }
  const std::vector<ComponentDeclaration>& declarations() const { return declarations_; }
  /// The parameters of every component of the graph, by instance name.
  std::vector<std::pair<std::string, ParameterReport>> parameters() const;
  /// The sections that components share, by name, as the first that read each saw it.
  std::map<std::string, ParameterReport> shared_parameters() const;
  /// The failsafe table: what components declared, and the inputs that may not be older than the graph says; by component.
  std::vector<std::pair<std::string, FailsafeRow>> failsafes() const;
  /// What goes wrong on purpose, by name: what, where and when.
  std::vector<std::pair<std::string, std::string>> faults() const;
  /// Of this process's callbacks, after the run.
  std::vector<CallbackStatistics> statistics() const;
  /// Lock-step only, else empty.
  std::string samples_sha256() const;
  /// Lock-step: something entered by accept_inputs.
  bool was_changed_from_outside() const { return outside_ && outside_->was_used(); }
  /// Seconds on the component clock since the run began.
  double elapsed_seconds() const;

 private:
  friend class HostSetup;
  friend class ProcessServices;

  void add_component(const ComponentNode& node, std::unique_ptr<Component> component, bool here,
                     ActorRole role);
  /// As the graph and the environment say.
  dds::Network network() const;
  void offer_lifecycle(Actor& actor, HostSetup& setup);
  /// Null where nobody follows.
  std::unique_ptr<class NestedLifecycle> led_by(Actor& leader) const;
  /// What goes wrong on purpose.
  void add_faults();
  /// Two managers for each robot, unless one comes from outside.
  void add_managers();
  void add_manager(const std::string& robot, Manager which);
  /// The process's own actors and the program's observers keep their places.
  std::vector<Actor*> bring_up_order() const;
  /// Activates all, or leaves them to a manager from outside; says why when one fails.
  std::optional<RunEnd> bring_up(const std::vector<Actor*>& order);
  /// Brings what is up to rest, backwards, whatever fails.
  void bring_down(const std::vector<Actor*>& order, RunEnd& end);
  /// A callback threw: its component is deactivated at once, which stops what it moves; all others get their
  /// time to rest.
  void end_by(const CallbackFailure& failure);
  void offer_parameters(Setup& setup, Actor& actor);
  void make_runner();
  void connect();
  void connect_services(Actor& actor);
  void connect_clients(Actor& actor);
  void announce_nodes();
  /// Off the wire: the others hear at once that we are gone, whatever a recording has still to write.
  void leave();
  void look_around(Time now);
  void tap_outputs();
  void log(const Actor& actor, LogLevel level, const std::string& text);
  void publish_log(const Actor& actor, LogLevel level, const std::string& text);
  std::vector<Actor*> local_actors() const;

  Graph graph_;
  HostOptions options_;
  std::vector<std::unique_ptr<Actor>> actors_;  ///< by rank; the process's own services first
  std::vector<Actor*> local_;
  std::vector<ComponentDeclaration> declarations_;
  std::unique_ptr<ComponentClock> clock_;
  std::unique_ptr<class WriterClock> writer_clock_;  ///< null unless time is real
  std::unique_ptr<OutsideInputs> outside_;           ///< lock-step
  std::vector<OutsideInputs::Topic> heard_outside_;
  const Actor* outside_actor_ = nullptr;  ///< through which what is accepted enters
  ServiceManager service_manager_;
  std::unique_ptr<Runner> runner_;
  std::mutex end_mutex_;  ///< of who ends the run while `runner_` is made
  std::optional<RunEnd> early_end_;
  std::unique_ptr<dds::Participant> participant_;
  std::unique_ptr<class WriterNames> writers_;
  std::unique_ptr<class CommandGuard> command_guard_;          ///< null in lock-step
  std::unique_ptr<class DuplicateNameGuard> duplicate_names_;  ///< null in lock-step
  std::unique_ptr<class NodeAnnouncement> announcement_;
  class ProcessServices* services_ = nullptr;
  class Injector* injector_ = nullptr;  ///< null: the graph has no faults
  std::optional<Time> started_;
  struct EarlyLine {
    const Actor* actor;
    LogLevel level;
    std::string text;
  };
  std::vector<EarlyLine> early_log_;  ///< of the time before the run
  Duration time_to_rest_;             ///< the longest that a component asked for
};

}  // namespace bw
