#include "components/program/drive.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <map>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include "components/evaluation/evaluation_parameters.hpp"
#include "components/program/bag_description.hpp"
#include "components/program/contacts/contact_report.hpp"
#include "components/program/course_observer.hpp"
#include "components/program/drive_page/drive_page.hpp"
#include "components/program/page_recording.hpp"
#include "components/program/recording.hpp"
#include "components/program/run_observer.hpp"
#include "components/program/score_card_json.hpp"
#include "components/program/snapshots.hpp"
#include "components/program/taps.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/host/service_manager.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

constexpr Duration kLongestJudgement = Duration::milliseconds(60'000);  // of one robot's contacts

/// Value of a parameter as text; `otherwise` where there is none.
std::string parameter_of(const Host& host, const std::string& component, std::string_view parameter,
                         const std::string& otherwise) {
  for (const auto& [name, report] : host.parameters()) {
    if (name != component) continue;
    for (const ParameterRow& row : report.rows) {
      if (row.name == parameter) return row.value;
    }
  }
  return otherwise;
}

/// What this process took so far.
nlohmann::json process_json() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {{"cpu_s", seconds(usage.ru_utime) + seconds(usage.ru_stime)}, {"max_rss_mb", peak_memory_mb()}};
}

/// Asks the host to end when a person does.
class InterruptWatch {
 public:
  explicit InterruptWatch(Host& host)
      : thread_([this, &host] {
          while (!done_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (!cli::interrupted()) continue;
            host.finish({.ok = true, .reason = "interrupted"}, false);
            return;
          }
        }) {}
  ~InterruptWatch() {
    done_ = true;
    thread_.join();
  }
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

/// The recording, the snapshots and the page of one drive, whichever of them are asked for.
class Bags {
 public:
  Bags(const Graph& graph, const DriveSettings& options)
      : graph_(graph), options_(options), lockstep_(options.host.clock == ClockMode::lockstep) {
    if (!options.record.empty()) recording_.emplace();
    if (graph.snapshot && options.snapshots) snapshots_.emplace();
    if (options.html.empty()) return;
    require_page("--html " + options.html.string());
    page_.emplace();
  }

  /// Before the host.
  void join(HostOptions& host_options, std::vector<ExtraComponent>& extra) {
    if (!recording_ && !snapshots_ && !page_) return;
    host_options.tap = taps_;
    if (lockstep_) return;
    if (recording_) extra.push_back({"recorder", recording_->make_reporter()});
    const std::string& process = options_.host.only_process;
    if (snapshots_) extra.push_back({"flight_recorder", snapshots_->make_reporter(process)});
  }
  void open(const Host& host) {
    if (snapshots_) taps_->add(snapshots_->open(graph_, host, options_.host, describe(host, options_.host)));
    if (recording_) {
      bag::BagWriterOptions writer = options_.record_options;
      writer.ros_distro = ros_distro_of(graph_);
      taps_->add(recording_->open(options_.record, {.writer = std::move(writer), .waits = lockstep_},
                                  describe(host, options_.host)));
    }
    if (page_) taps_->add(page_->open(lockstep_, describe(host, options_.host)));
  }
  /// Says what was lost, and where snapshots are.
  void finish(const Host& host) {
    if (snapshots_) snapshots_->finish();
    if (snapshots_) std::cerr << snapshots_->untold();
    if (page_) page_fault_ = page_->finish(host, page_name(), options_.html);
    if (!recording_) return;
    if (const std::string lost = recording_->finish(host); !lost.empty()) std::cerr << lost << "\n";
  }
  void add_to(nlohmann::json& json) const {
    if (recording_) json["recording"] = recording_->json();
    if (snapshots_) json["snapshots"] = snapshots_->json();
  }
  [[nodiscard]] const std::string& page_fault() const { return page_fault_; }

 private:
  /// hallway seed 7
  [[nodiscard]] std::string page_name() const {
    return graph_.path.stem().string() + " seed " + std::to_string(options_.host.seed);
  }

  const Graph graph_;  ///< with the components that are left out
  const DriveSettings& options_;
  bool lockstep_;
  std::shared_ptr<Taps> taps_ = std::make_shared<Taps>();
  std::optional<Recording> recording_;
  std::optional<Snapshots> snapshots_;
  std::optional<PageRecording> page_;
  std::string page_fault_;
};

}  // namespace

const ComponentNode* find_type(const Graph& graph, const std::string& type, const std::string& process) {
  for (const ComponentNode& node : graph.components) {
    if (node.enabled && node.type == type && (process.empty() || node.process == process)) return &node;
  }
  return nullptr;
}

namespace {

/// A parameter that the command line decides.
void set_parameter(Graph& graph, const ComponentNode& node, const char* parameter, const std::string& text,
                   bool is_text = false) {
  ConfigNode value;
  value.kind = ConfigNode::Kind::kScalar;
  value.scalar = text;
  value.quoted = is_text;
  apply_override(graph, Override{.path = {node.name, parameter}, .value = std::move(value)});
}

/// One picture for each robot: drive.svg, drive_robot2.svg.
std::filesystem::path picture_of(const std::filesystem::path& svg, const std::string& robot) {
  if (robot.empty()) return svg;
  return svg.parent_path() / (svg.stem().string() + "_" + robot + svg.extension().string());
}

/// The first of this type of each robot, or of the only one.
std::vector<const ComponentNode*> find_each(const Graph& graph, const std::string& type,
                                            const std::string& process) {
  std::vector<const ComponentNode*> found;
  for (const ComponentNode& node : graph.components) {
    const bool is_meant =
        node.enabled && node.type == type && (process.empty() || node.process == process) &&
        std::ranges::none_of(found, [&](const ComponentNode* other) { return other->robot == node.robot; });
    if (is_meant) found.push_back(&node);
  }
  return found;
}

void set_up_evaluation(Graph& graph, const DriveSettings& options) {
  for (const ComponentNode* node : find_each(graph, "evaluation", options.host.only_process)) {
    if (!options.svg.empty())
      set_parameter(graph, *node, "svg",
                    std::filesystem::absolute(picture_of(options.svg, node->robot)).string(), true);
    if (options.longest)
      set_parameter(graph, *node, "time_limit", std::to_string(options.longest->to_seconds()));
    if (options.stays && find_dotted(node->parameters, "scored") == nullptr)
      set_parameter(graph, *node, "scored", std::string(text_of(Scored::drives)));
  }
}

/// All robots of the graph, whichever process judges them.
std::vector<RobotObservation> observed(const Graph& graph) {
  std::vector<RobotObservation> robots;
  for (const ComponentNode* node : find_each(graph, "evaluation", "")) {
    robots.push_back({.robot = node->robot,
                      .card_topic = node->topic_of("score_card"),
                      .truth_topic = node->topic_of("sim/ground_truth")});
  }
  return robots;
}

/// Where the course of whom `evaluation` judges is heard.
CourseTopics course_topics(const ComponentNode& evaluation) {
  const CourseTopics declared;
  return {.truth = evaluation.topic_of(declared.truth),
          .status = evaluation.topic_of(declared.status),
          .map = evaluation.topic_of(declared.map),
          .true_map = evaluation.topic_of(declared.true_map),
          .shapes = evaluation.topic_of(declared.shapes)};
}

/// A component of its own for the course of whom `evaluation` judges; stays empty with nullptr.
std::shared_ptr<std::optional<RunRecorder>> observe_course(const ComponentNode* evaluation,
                                                           std::vector<ExtraComponent>& extra) {
  auto course = std::make_shared<std::optional<RunRecorder>>();
  if (evaluation == nullptr) return course;
  extra.push_back({.name = "course_observer",
                   .component = std::make_unique<CourseObserver>(course, course_topics(*evaluation)),
                   .node_namespace = evaluation->node_namespace});
  return course;
}

/// Facts of each robot whose planner runs here, by robot; of the run as a whole those of the slowest planner.
RunFacts facts_of(RunFacts facts, const Host& host, const std::string& planner) {
  facts.planner_component = planner;
  facts.planner_name = planner.empty() ? "" : parameter_of(host, planner, "algorithm", planner);
  return facts;
}

std::vector<RobotContacts> contacts_of(const std::vector<HeardDrive>& drives) {
  std::vector<RobotContacts> contacts;
  for (const HeardDrive& drive : drives) contacts.push_back({drive.robot, drive.contacts});
  return contacts;
}

std::string slowest(const Host& host, const std::map<std::string, std::string>& planners) {
  std::string found;
  double longest = -1.0;
  for (const auto& [robot, planner] : planners) {
    const double p95 = planner_cycle(host.statistics(), planner).run.quantile_ms(0.95);
    if (p95 > longest) found = planner;
    longest = std::max(longest, p95);
  }
  return found;
}

}  // namespace

DriveResult drive(Graph graph, const DriveSettings& options) {
  const ComponentNode* evaluation = find_type(graph, "evaluation", options.host.only_process);
  const std::string evaluation_name = evaluation == nullptr ? "" : evaluation->name;
  std::map<std::string, std::string> planners;  // by robot
  for (const ComponentNode* node : find_each(graph, "local_planner", options.host.only_process))
    planners[node->robot] = node->name;
  const std::string graph_file = graph.path.string();
  set_up_evaluation(graph, options);

  DriveResult result{.judged = evaluation != nullptr};
  auto seen = std::make_shared<Observation>();
  std::vector<std::shared_ptr<std::optional<RunRecorder>>> heard;  // of each robot
  Host* running = nullptr;
  std::vector<ExtraComponent> extra;
  if (result.judged) {
    seen->robots = observed(graph);
    const auto planner_ms = [&running, &planners] {
      if (running == nullptr || planners.empty()) return 0.0;
      return planner_cycle(running->statistics(), planners.begin()->second).run.quantile_ms(0.5);
    };
    // Contacts are heard by a component that is there anyway: what the run publishes stays the same to the
    // byte.
    std::vector<CourseListener> listeners;
    for (const ComponentNode* node : find_each(graph, "evaluation", "")) {
      if (!options.contacts) break;
      heard.push_back(std::make_shared<std::optional<RunRecorder>>());
      listeners.emplace_back(heard.back(), course_topics(*node));
    }
    extra.push_back({.name = "run_observer",
                     .component = std::make_unique<RunObserver>(seen, options.show_progress, options.stays,
                                                                planner_ms, std::move(listeners)),
                     .node_namespace = evaluation->node_namespace});
  }
  const auto course = observe_course(options.course ? evaluation : nullptr, extra);
  HostOptions host_options = options.host;
  Bags bags(graph, options);
  bags.join(host_options, extra);
  Host host(std::move(graph), host_options, std::move(extra));
  bags.open(host);
  result.has_goal = !result.judged || parameter_of(host, evaluation_name, "scored", "drive") != "run";
  running = &host;
  slowest(host, planners);  // throws before the drive, not after it
  cli::catch_interrupts();
  // Whoever reads our output may go first, as `tee` does when its terminal is closed: no reason to leave a
  // robot driving.
  std::signal(SIGPIPE, SIG_IGN);
  const InterruptWatch watch(host);
  const Duration started = steady_time();
  result.end = host.run(options.longest);
  const double real_s = (steady_time() - started).to_seconds();
  bags.finish(host);
  result.page_fault = bags.page_fault();
  if (result.end.has_thrown) throw RunFailed(result.end.reason);

  const RunFacts facts{.graph = graph_file,
                       .seed = options.host.seed,
                       .realtime_factor = host.elapsed_seconds() / real_s,
                       .samples_sha256 = host.samples_sha256(),
                       .end_reason = result.end.reason,
                       .has_goal = result.has_goal,
                       .stays = options.stays};
  result.card = seen->card();
  if (*course) result.course = (*course)->recording();
  result.json = to_json(result.card, facts_of(facts, host, slowest(host, planners)), host.statistics());
  for (std::size_t i = 0; i < heard.size(); ++i) {
    if (!*heard[i]) continue;
    HeardDrive& one = result.heard.emplace_back(seen->robots[i].robot, (*heard[i])->recording());
    ServiceManager().takes_time_to_end(kLongestJudgement);  // who started us waits for the card
    one.contacts = judge_contacts(one.recording);
  }
  if (!result.heard.empty()) add_contacts(result.json, contacts_of(result.heard));
  bags.add_to(result.json);
  if (options.host.clock == ClockMode::lockstep)
    result.json["inputs"] = host.was_changed_from_outside() ? "outside" : "graph";
  result.json["real_time_s"] = real_s;
  result.json["process"] = process_json();
  for (const RobotObservation& one : seen->robots) {
    if (!one.robot.empty()) {
      nlohmann::json& card = result.json["robots"][one.robot];
      card = robot_json(one, facts_of(facts, host, planners[one.robot]), host.statistics());
      for (const HeardDrive& drive : result.heard)
        if (drive.robot == one.robot) add_contacts(card, {{"", drive.contacts}});
    } else if (one.card) {
      result.json["robot_path"] = path_json(one.path, *one.card);
    }
  }
  return result;
}

}  // namespace bw
