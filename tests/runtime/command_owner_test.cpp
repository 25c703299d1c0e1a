// Commands on the wire, in real time: whom a reader hears, with others on the same topic. Nothing here
// depends on how fast.
#include <atomic>
#include <functional>
#include <set>
#include <thread>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gmock/gmock.h>
#include <rcl_interfaces/msg/log.hpp>
#include <std_msgs/msg/float64.hpp>

#include "runtime/host/command_watch.hpp"
#include "runtime/host/host.hpp"
#include "runtime/ros/discovery_info.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {
namespace {

using diagnostic_msgs::msg::DiagnosticArray;
using rcl_interfaces::msg::Log;
using std_msgs::msg::Float64;

constexpr double kForeign = 666.0;

class Scripted final : public Component {
 public:
  explicit Scripted(std::function<void(Setup&)> script) : script_(std::move(script)) {}
  void configure(Setup& setup) override { script_(setup); }

 private:
  std::function<void(Setup&)> script_;
};

void add(Graph& graph, ComponentNode node, const std::function<void(Setup&)>& script) {
  static int counter = 0;
  node.type = "commanding" + std::to_string(counter++);
  register_component(node.type, [script] { return std::make_unique<Scripted>(script); });
  graph.components.push_back(std::move(node));
}

/// A node `owner` that counts up on the command `motor`, and a node `base` that obeys it.
struct Machine {
  std::atomic<int> obeyed = 0;
  std::atomic<int> foreign = 0;
  Graph graph;
  std::unique_ptr<Host> host;
  std::thread thread;

  explicit Machine(bool is_open = false) {
    if (!is_open) {
      add(graph, {.name = "owner"}, [](Setup& setup) {
        setup.every(Duration::milliseconds(5), "tick",
                    [out = setup.command<Float64>("motor")](const Tick& tick) {
                      Float64 message;
                      message.data(static_cast<double>(tick.sequence % 100));
                      out.publish(message);
                    });
      });
    }
    ComponentNode base{.name = "base"};
    if (is_open) base.inputs.push_back({.name = "motor", .external = true});
    add(graph, base, [this](Setup& setup) {
      setup.input<Float64>("motor", Qos::command(), [this](const Float64& message, const Tick&) {
        ++(message.data() == kForeign ? foreign : obeyed);
      });
    });
    host = std::make_unique<Host>(graph, HostOptions{.clock = ClockMode::wall});
    thread = std::thread([this] { host->run(Duration::seconds(60)); });
  }
  ~Machine() { stop(); }
  void stop() {
    if (!thread.joinable()) return;
    host->finish({.ok = true, .reason = "enough"}, true);
    thread.join();
  }
  /// The base goes on obeying.
  bool is_obeying() {
    const int before = obeyed;
    return eventually([&] { return obeyed > before + 5; });
  }
};

/// A ROS node of a participant of its own.
struct Outsider {
  dds::Participant participant{{.network = dds::Network::from_environment({})}};
  std::unique_ptr<dds::Writer> announcement;
  std::unique_ptr<dds::Writer> writer = participant.create_writer(end<Float64>("motor", Qos::standard()));
  std::unique_ptr<dds::Reader> rosout = participant.create_reader(end<Log>("rosout", Qos::rosout()), [] {});
  std::unique_ptr<dds::Reader> diagnostics =
      participant.create_reader(end<DiagnosticArray>("diagnostics", Qos::standard()), [] {});
  std::string logged;
  std::string status;  ///< of the process's own node

  explicit Outsider(const std::string& name) {
    announcement = participant.create_writer(
        {.topic = kDiscoveryTopic, .type = kDiscoveryType, .qos = Qos::latched(), .user_data = {}});
    NodeEntities node{.node_namespace = "/", .name = name, .readers = {}, .writers = {writer->guid()}};
    announcement->write(
        encode({.participant = participant.guid(), .nodes = {node}}, GidFormat::iron_and_later));
  }
  template <class M>
  static dds::EndpointOptions end(const std::string& topic, const Qos& qos) {
    return {
        .topic = "rt/" + topic, .type = std::string(MessageTraits<M>::dds_name), .qos = qos, .user_data = {}};
  }
  void command() const {
    Float64 message;
    message.data(kForeign);
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    writer->write(cdr);
  }
  void listen() {
    dds::Sample sample;
    for (Log log; rosout->take(sample) && deserialize(sample.cdr, log);) logged += log.msg() + "\n";
    for (DiagnosticArray all; diagnostics->take(sample) && deserialize(sample.cdr, all);) {
      for (const auto& its : all.status()) {
        if (its.name() == "bandwagon") status = its.message();
      }
    }
  }
  bool hears_commands(int count) {
    const auto reader = participant.create_reader(end<Float64>("motor", Qos::standard()), [] {});
    dds::Sample sample;
    return eventually([&] {
      while (reader->take(sample)) --count;
      return count <= 0;
    });
  }
  bool has_heard(const std::string& text) {
    listen();
    return logged.find(text) != std::string::npos;
  }
  bool hears(const std::string& text) {
    return eventually([&] { return has_heard(text); });
  }
  bool sees(const std::string& text) {
    return eventually([&] {
      listen();
      return status.find(text) != std::string::npos;
    });
  }
};

TEST(CommandOwner, AForeignWriterAtFullSpeedIsNotHeardAndIsNamed) {
  Outsider outsider("teleop");
  std::atomic<bool> over = false;
  std::thread flood([&] {
    while (!over) {
      outsider.command();
      std::this_thread::yield();
    }
  });
  Machine machine;
  EXPECT_TRUE(machine.is_obeying());
  EXPECT_TRUE(outsider.hears("refused: /motor is commanded by /owner alone; /teleop publishes it too"))
      << outsider.logged;
  EXPECT_TRUE(outsider.sees("/motor: refused: /teleop")) << outsider.status;
  EXPECT_TRUE(machine.is_obeying());
  EXPECT_EQ(outsider.writer->matched_readers(), 0);
  over = true;
  flood.join();
  outsider.writer.reset();
  EXPECT_TRUE(outsider.sees("ok")) << outsider.status;
  EXPECT_EQ(machine.foreign, 0);
}

TEST(CommandOwner, WhoCameAndWentAtOnceIsNamed) {
  Outsider witness("witness");
  witness.writer.reset();
  Machine machine;
  EXPECT_TRUE(machine.is_obeying());
  ASSERT_TRUE(eventually([&] { return !witness.participant.remote_participants().empty(); }));
  {
    const Outsider once("once");
    ASSERT_TRUE(eventually([&] { return once.announcement->matched_readers() > 0; }));
    ASSERT_TRUE(once.announcement->wait_until_received(Duration::seconds(20)));
    // A node that goes says so before its participant does.
    once.announcement->write(
        encode({.participant = once.participant.guid(), .nodes = {}}, GidFormat::iron_and_later));
  }
  EXPECT_TRUE(witness.hears("; /once publishes it too")) << witness.logged;
  EXPECT_EQ(machine.foreign, 0);
}

TEST(CommandOwner, AnInputThatTheGraphOpensHearsAnybody) {
  const Outsider outsider("teleop");
  const Machine machine(true);
  EXPECT_TRUE(eventually([&] {
    outsider.command();
    return machine.foreign > 5;
  }));
}

TEST(CommandOwner, OfTwoOwnersNobodyIsObeyedWhileBothCommand) {
  Outsider witness("witness");
  witness.writer.reset();
  Machine machine;
  EXPECT_TRUE(machine.is_obeying());
  {
    // As the owner of the same graph, run a second time, does.
    dds::EndpointOptions options = Outsider::end<Float64>("motor", Qos::command());
    options.partitions = {"", command_partition("/owner")};
    witness.writer = witness.participant.create_writer(options);
    ASSERT_TRUE(eventually([&] { return witness.writer->matched_readers() > 0; }));
    // One that says nothing, as one that was killed a moment ago, disturbs nobody.
    EXPECT_TRUE(machine.is_obeying());
    // It answers each of the owner's commands by one of its own.
    const auto reader =
        witness.participant.create_reader(Outsider::end<Float64>("motor", Qos::standard()), [] {});
    int heard = 0;
    int obeyed = 0;
    dds::Sample sample;
    EXPECT_TRUE(eventually([&] {
      for (Float64 message; reader->take(sample) && deserialize(sample.cdr, message);) {
        if (message.data() == kForeign) continue;
        witness.command();
        if (++heard == 10) obeyed = machine.obeyed;
      }
      return heard >= 100;
    }));
    EXPECT_EQ(machine.obeyed, obeyed);
    EXPECT_EQ(machine.foreign, 0);
    // It is said while both go on.
    EXPECT_TRUE(eventually([&] {
      witness.command();
      return witness.has_heard("nobody is obeyed on /motor while two command: 2 publishers are /owner");
    })) << witness.logged;
    EXPECT_TRUE(machine.is_obeying());
    witness.writer.reset();
  }
  EXPECT_TRUE(witness.hears("on /motor one is obeyed again")) << witness.logged;
}

}  // namespace
}  // namespace bw::test
