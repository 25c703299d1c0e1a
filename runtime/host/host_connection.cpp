// How a host comes onto the wire: its ends, its taps, its nodes, and the watch over its commands.
#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "runtime/host/command_guard.hpp"
#include "runtime/host/duplicate_name_guard.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/host/process_services.hpp"
#include "runtime/host/terminal.hpp"
#include "runtime/host/wall_runner.hpp"
#include "runtime/host/writer_clock.hpp"
#include "runtime/host/writer_names.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/discovery_info.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/ros/service_ends.hpp"

namespace bw {
namespace {

dds::EndpointOptions endpoint_options(const std::string& topic, const MessageType& type, const Qos& qos) {
  return {.topic = dds_topic(topic),
          .type = std::string(type.dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(type.type_hash))};
}

/// Everybody may read a command; its readers in the graph hear its owner alone.
std::vector<std::string> partitions_of(const OutputEnd& output) {
  if (!output.command) return {};
  const Actor& owner = output.owner;
  return {"",
          command_partition(full_name({.node_namespace = owner.node_namespace, .name = owner.node_name}))};
}

std::vector<std::string> partitions_of(const Input& input) {
  if (input.commander.empty()) return {};
  return {command_partition(input.commander)};
}

}  // namespace

dds::Network Host::network() const {
  return dds::Network::from_environment(graph_.settings.transport == "lan" ? dds::Transport::lan
                                                                           : dds::Transport::localhost);
}

void Host::make_runner() {
  const std::lock_guard lock(end_mutex_);
  if (options_.clock == ClockMode::lockstep) {
    runner_ = std::make_unique<LockstepRunner>(
        local_, LockstepOptions{.pace = options_.pace,
                                .start = options_.start.value_or(LockstepRunner::kStart),
                                .source = options_.source,
                                .outside = outside_.get()});
  } else {
    runner_ = std::make_unique<WallRunner>(
        local_, *clock_, service_manager_,
        [this](const Actor& actor, const std::string& text) { log(actor, LogLevel::warn, text); });
  }
  if (early_end_) runner_->finish(*early_end_, {});  // nothing has moved yet
}

void Host::connect() {
  const bool lockstep = options_.clock == ClockMode::lockstep;
  const std::string private_partition = lockstep ? "lockstep" + std::to_string(getpid()) : "";
  participant_ = std::make_unique<dds::Participant>(dds::ParticipantOptions{
      .network = network(), .private_partition = private_partition, .alone = options_.alone});
  make_runner();
  if (options_.clock == ClockMode::wall) {
    const bool is_local = network().transport == dds::Transport::localhost;
    writer_clock_ = std::make_unique<WriterClock>(
        is_local ? WriterClock::Reach::this_host : WriterClock::Reach::network, system_clock_offset());
  }
  runner_->set_on_failure([this](const CallbackFailure& failure) { end_by(failure); });
  std::vector<Actor*> all;
  for (const auto& actor : actors_) all.push_back(actor.get());
  for (Actor* actor : all) actor->writer_clock = writer_clock_.get();
  const std::vector<WatchedTopic> watched = find_watched_topics(all, local_);
  // In lock-step all ends are in the participant's own partition already.
  const auto partitions = [lockstep](const auto& end) {
    return lockstep ? std::vector<std::string>() : partitions_of(end);
  };
  // Writers first: in one participant a match is immediate, so no reader misses a latched first sample.
  for (Actor* actor : local_) {
    for (const auto& output : actor->outputs) {
      dds::EndpointOptions options = endpoint_options(output->topic, output->type, output->qos);
      options.partitions = partitions(*output);
      if (actor == outside_actor_) options.partitions = {private_partition};  // outside has said it already
      output->writer = participant_->create_writer(options);
      output->always_read = lockstep || (options_.tap && options_.tap->wants_everything());
    }
  }
  if (options_.tap) tap_outputs();
  for (Actor* actor : local_) {
    for (const auto& input : actor->inputs) {
      dds::EndpointOptions options = endpoint_options(input->topic, input->type, input->qos);
      options.partitions = partitions(*input);
      input->reader =
          participant_->create_reader(options, [this, end = input.get()] { runner_->arrived(*end); });
    }
  }
  for (Actor* actor : local_) {
    for (const auto& action : actor->actions) action->runner = runner_.get();
    connect_services(*actor);
  }
  for (Actor* actor : local_) connect_clients(*actor);
  if (outside_) outside_->connect(*participant_, heard_outside_, local_);
  if (lockstep) return;
  writers_->connect(*participant_);
  command_guard_ = std::make_unique<CommandGuard>(*participant_, watched, local_);
  duplicate_names_ = std::make_unique<DuplicateNameGuard>(*participant_, find_own_nodes(local_));
}

// The reply's writer first: a server that takes requests and cannot answer makes every client wait.
void Host::connect_services(Actor& actor) {
  const bool lockstep = options_.clock == ClockMode::lockstep;
  for (const auto& service : actor.services) {
    ServiceEnd* end = service.get();
    end->sink = runner_.get();
    end->keeps_foreign_apart = lockstep;
    end->complain = [this, &actor, lockstep](const std::string& text) {
      // In lock-step not on /rosout: what comes from outside changes no sample.
      if (lockstep) return write_to_terminal(LogLevel::warn, "[" + actor.name + "] " + text);
      log(actor, LogLevel::warn, text);
    };
    const auto on_match = [this, end] {
      // Within a run in lock-step everybody is connected from the beginning.
      if (outside_) {
        outside_->has_news();
      } else {
        runner_->arrived(*end);
      }
    };
    end->writer =
        participant_->create_writer(service_end(reply_topic(end->service), end->type.response), on_match);
    dds::EndpointOptions options = service_end(request_topic(end->service), end->type.request);
    if (lockstep) options.partitions = {"", participant_->private_partition()};
    end->reader = participant_->create_reader(options, [this, end] { runner_->arrived(*end); });
  }
}

void Host::connect_clients(Actor& actor) {
  const bool lockstep = options_.clock == ClockMode::lockstep;
  for (const auto& client : actor.clients) {
    ClientEnd* end = client.get();
    end->runner = runner_.get();
    const std::function<void()> on_arrival = [this, end] { runner_->arrived(*end); };
    // A request waits until both halves of its server are connected. Within a run in lock-step they are from
    // the beginning.
    const std::function<void()> on_match = lockstep ? nullptr : on_arrival;
    end->reader = participant_->create_reader(service_end(reply_topic(end->service), end->type.response),
                                              on_arrival, on_match);
    dds::EndpointOptions options = service_end(request_topic(end->service), end->type.request);
    if (lockstep) options.partitions = {participant_->private_partition()};
    end->writer = participant_->create_writer(options, on_match);
  }
}

void Host::tap_outputs() {
  std::vector<const OutputEnd*> outputs;
  for (const Actor* actor : local_) {
    for (const auto& output : actor->outputs) outputs.push_back(output.get());
  }
  options_.tap->connect(outputs);
  runner_->set_tap(options_.tap.get());
}

void Host::announce_nodes() {
  AnnouncementOptions options{.distro = graph_.settings.ros_distro};
  // In lock-step nobody of outside is to decide anything, not even a line of the log.
  options.looks_around = options_.clock != ClockMode::lockstep;
  if (options.looks_around)
    options.warn = [this](const std::string& text) { log(*local_.front(), LogLevel::warn, text); };
  announcement_ = std::make_unique<NodeAnnouncement>(*participant_, std::move(options));
  std::vector<dds::Guid> of_every_node;  // one writer of the process, told at each of its nodes
  for (const auto& output : actors_.front()->outputs) {
    if (output->topic == kRosout || output->topic == kParameterEvents)
      of_every_node.push_back(output->writer->guid());
  }
  for (const Actor* actor : local_) {
    NodeEntities node{
        .node_namespace = actor->node_namespace, .name = actor->node_name, .readers = {}, .writers = {}};
    for (const auto& input : actor->inputs) node.readers.push_back(input->reader->guid());
    for (const auto& output : actor->outputs) node.writers.push_back(output->writer->guid());
    if (actor->rank > 0) node.writers.insert(node.writers.end(), of_every_node.begin(), of_every_node.end());
    for (const auto& service : actor->services) {
      node.readers.push_back(service->reader->guid());
      node.writers.push_back(service->writer->guid());
    }
    for (const auto& client : actor->clients) {
      node.readers.push_back(client->reader->guid());
      node.writers.push_back(client->writer->guid());
    }
    announcement_->add(std::move(node));
  }
  announcement_->publish();
}

void Host::leave() {
  announcement_.reset();
  for (const auto& actor : actors_) {
    for (const auto& output : actor->outputs) {
      output->sink = nullptr;
      output->writer.reset();
    }
    for (const auto& input : actor->inputs) input->reader.reset();
    for (const auto& service : actor->services) {
      service->reader.reset();
      service->writer.reset();
    }
    for (const auto& client : actor->clients) {
      client->reader.reset();
      client->writer.reset();
    }
  }
  command_guard_.reset();
  duplicate_names_.reset();
  writers_->disconnect();
  participant_.reset();
}

/// Says what is news; the rest is on /diagnostics as long as it holds.
void Host::look_around(Time now) {
  if (!command_guard_) return;
  announcement_->rethrow();
  Actor& services = *actors_.front();
  for (const CommandWatch::News& news : command_guard_->look(now)) log(services, news.level, news.text);
  for (const DuplicateNameWatch::News& news : duplicate_names_->look()) log(services, news.level, news.text);
  if (const auto change = writer_clock_ ? writer_clock_->look(system_clock_offset()) : std::nullopt)
    log(services, LogLevel::warn,
        fmt::format(
            "the system clock was set by {:.3f} s: stamps of other processes are of another clock from now on",
            change->to_seconds()));
  using Level = DiagnosticReporter::Level;
  Level level = Level::ok;
  std::string message = "ok";
  const auto show = [&](const std::string& about, LogLevel log_level, const std::string& text) {
    services.set_value(about, text);
    const Level its = log_level == LogLevel::error  ? Level::error
                      : log_level == LogLevel::warn ? Level::warn
                                                    : Level::ok;
    if (its > level) message = about + ": " + text;
    level = std::max(level, its);
  };
  for (const auto& [topic, state] : command_guard_->states()) show(topic, state.level, state.text);
  for (const auto& [node, state] : duplicate_names_->states()) show(node, state.level, state.text);
  services.report(level, message);
}

}  // namespace bw
