// A graph file as values: which components run where, and how their names are joined. Nothing here starts
// anything.
//
//   ros_distro: auto                # auto | humble | jazzy | kilted | lyrical (runtime/ros/node_announcement.hpp)
//   namespace: ""                   # relative names go below it
//   frame_prefix: ""                # of all frames but map, which robots share
//   robots:                         # several: each has all components below it that are not shared, its names below
//                                   # robot1, its frames prefixed robot1/, processes and lanes of its own
//     robot1: {navigator: {goal: {x: 9.0}}}    # parameters of its own, over those of the component
//     robot2:
//   transport: localhost            # localhost | lan
//   plugins: [path.so]              # paths are relative to the file they stand in
//   robot: ../robots/generic.yaml   # a shared section: a file or a map
//   lifecycle: own                  # own | external: components stay unconfigured until a manager comes, such as Nav2's;
//                                   # ros_distro is named then
//   bring_up: [map_server, amcl]    # activated first and in this order, as a lifecycle_manager's node_names; the others
//                                   # follow in rank order
//   snapshot: {keep: 30s, on: [contact], to: near_misses}    # snapshot_settings.hpp
//   emulate: true                 # devices of the robot are emulated (emulation.hpp): run --emulate
//   faults: {...}                 # what goes wrong, and when (fault_settings.hpp): a file or a map
//   processes: {planning: {memory: 800MB, cpu: 1.5}}    # what each may take (process_limits.hpp)
//   tolerances: {...}               # of replays (runtime/recording/replay/tolerances.hpp): a file or a map
//   components:
//     local_planner:                # the node's name; the order is the rank
//       type: local_planner         # default: the name
//       process: planning           # default: main
//       lane: planner               # default: main
//       priority: real_time         # default: normal; its lane runs before all that is normal, where the system allows it
//       enabled: true               # false: left out; --set local_planner.enabled=true brings it back
//       latency: 20ms
//       manager: navigation         # navigation | localization | none: which of our lifecycle managers pauses it
//       follows: controller_server  # goes through its states with that component, managed and bonded by none
//       namespace: robot1           # below the graph's, unless absolute
//       shared: true                # one for all robots
//       parameters: {...}           # or a file
//       remap: {cmd_vel_nav: cmd_vel}
//       inputs: {odom: {max_age: 500ms, on_stale: stop, external: false}}
//       emulation: {base: {enabled: true}, laser: {remap: {scan: sim/scan}}}   # laid over it while that device is emulated
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/ros_distro.hpp"
#include "runtime/base/time.hpp"
#include "runtime/graph/emulation.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/graph/process_limits.hpp"
#include "runtime/graph/snapshot_settings.hpp"
#include "runtime/parameters/config_node.hpp"

namespace bw {

struct Override;

/// What happens to a component when an input is older than its max_age.
enum class OnStale { stop, degrade, ignore };

/// Which of this program's two lifecycle managers a component belongs to; what belongs to none stays up.
enum class Manager { navigation, localization, none };

struct InputSettings {
  std::string name;  ///< as the component declares it
  std::optional<Duration> max_age = std::nullopt;
  OnStale on_stale = OnStale::stop;
  bool external = false;  ///< somebody outside of this graph publishes it
  Location where;
};

struct ComponentNode {
  std::string
      name;  ///< unique in the graph: the node's, of one of several robots below the robot's: robot1/people
  std::string type;
  std::string process = "main";
  std::string lane = "main";
  bool is_real_time = false;  ///< its lane comes before others, on a real clock
  bool enabled = true;        ///< hosts leave out what is not
  Duration latency;           ///< computing time in lock-step, at least 0
  Manager manager = Manager::navigation;
  std::string follows;               ///< the component whose states it goes through with; empty: its own
  std::string node_namespace = "/";  ///< absolute
  ConfigNode parameters;             ///< a map or nothing, overrides applied
  std::vector<Remap> remaps;
  std::vector<InputSettings> inputs;
  std::vector<EmulationChange> emulation;
  Location where;
  std::string robot = {};  ///< of a graph with several: whose it is; empty: shared
  std::string node = {};   ///< on the wire; empty: as `name`, without the robot's

  std::string node_name() const;
  /// The absolute topic behind a declared name.
  std::string topic_of(std::string_view declared) const;
  const InputSettings* input(std::string_view declared) const;
};

struct GraphSettings {
  RosDistro ros_distro = RosDistro::automatic;
  std::string graph_namespace;
  std::string frame_prefix;
  std::string transport = "localhost";
  bool external_lifecycle = false;   ///< a manager from outside brings the components up
  std::vector<std::string> plugins;  ///< resolved
};

struct Graph {
  std::filesystem::path path;
  GraphSettings settings;
  std::map<std::string, ConfigNode>
      shared;             ///< sections such as `robot` and `faults`, overrides applied; absent if not given
  ConfigNode tolerances;  ///< by how much a replay may differ; a map or nothing
  std::optional<SnapshotSettings> snapshot;     ///< absent if not given
  std::vector<ComponentNode> components;        ///< in rank order
  std::vector<std::string> bring_up;            ///< names of components that come up first, in this order
  std::vector<std::string> robots;              ///< empty: one, without a name
  std::map<std::string, ProcessLimits> limits;  ///< by process

  const ComponentNode* find(std::string_view component) const;
  /// Names of the processes, in the order of their first components.
  std::vector<std::string> processes() const;
  /// Those that go through their states with `leader`, in rank order; what is not enabled is left out.
  std::vector<const ComponentNode*> followers_of(std::string_view leader) const;
  /// The components in the order in which they are configured and activated; the way down is backwards. Who
  /// follows comes before its leader.
  std::vector<const ComponentNode*> bring_up_order() const;
};

/// Overrides are `component.param=value`, `component.enabled=true|false`, `component.process=NAME`, `section.param=value`,
/// `section=FILE`, `ros_distro=NAME` or `emulate=true`, which comes after those of sections and before those
/// of components; of several robots each is meant, one alone by `robot/component.param=value`. Throws
/// ConfigError with all violations that were found.
Graph load_graph(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// One more override of a graph that is loaded. Throws ConfigError.
void apply_override(Graph& graph, const Override& change);

}  // namespace bw
