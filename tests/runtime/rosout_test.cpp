// What reaches /rosout: every line of every component and of the host, under the name of its logger.
#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rcl_interfaces/msg/log.hpp>
#include <std_msgs/msg/float64.hpp>

#include "runtime/host/host.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {
namespace {

using rcl_interfaces::msg::Log;
using std_msgs::msg::Float64;
using test::eventually;
using testing::ElementsAre;

/// `name: text` of every line heard.
std::string text_of(const Log& line) { return line.name() + ": " + line.msg(); }

// A line of configure() comes with the run's first instant, under the name that rclcpp gives the logger of
// /robot1/front/eye.
TEST(Rosout, HasWhatWasSaidBeforeTheRun) {
  std::vector<std::string> heard;
  Graph graph;
  graph.components.push_back(scripted({.name = "eye", .node_namespace = "/robot1/front"},
                                      [](bw::Setup& setup) { setup.log().warn("dusty"); }));
  graph.components.push_back(scripted({.name = "listener"}, [&](bw::Setup& setup) {
    setup.log().info("listening");
    setup.input<Log>(
        "/rosout", Qos::rosout(),
        [&](const Log& line, const Tick&) {
          heard.push_back(text_of(line));
          EXPECT_TRUE(line.file().empty());
          EXPECT_EQ(line.line(), 0U);
        },
        Need::optional);
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::seconds(0.1));
  EXPECT_THAT(heard, ElementsAre("robot1.front.eye: dusty", "listener: listening"));
}

/// Reads /rosout beside a run, as rqt_console does.
class Console {
 public:
  Console()
      : participant_({.network = dds::Network::from_environment({})}),
        reader_(participant_.create_reader({.topic = "rt/rosout",
                                            .type = std::string(MessageTraits<Log>::dds_name),
                                            .qos = Qos::rosout(),
                                            .user_data = {}},
                                           [] {})) {}
  bool hears(const std::string& line) {
    return eventually([&] {
      for (dds::Sample sample; reader_->take(sample);) {
        Log message;
        if (deserialize(sample.cdr, message)) lines_.push_back(text_of(message));
      }
      return std::ranges::find(lines_, line) != lines_.end();
    });
  }
  std::ptrdiff_t count(const std::string& line) const { return std::ranges::count(lines_, line); }
  dds::Participant& participant() { return participant_; }

 private:
  dds::Participant participant_;
  std::unique_ptr<dds::Reader> reader_;
  std::vector<std::string> lines_;
};

TEST(Rosout, HasWhatTheHostSays) {
  Graph graph;
  graph.components.push_back(scripted({.name = "eye"}, [](bw::Setup& setup) {
    setup.log().info("open");
    setup.input<Float64>(
        "value", Qos::standard(), [](const Float64&, const Tick&) {}, Need::optional);
  }));
  Console console;
  const auto writer =
      console.participant().create_writer({.topic = "rt/value",
                                           .type = std::string(MessageTraits<Float64>::dds_name),
                                           .qos = Qos::standard(),
                                           .user_data = {}});
  Host host(graph, {.clock = ClockMode::wall});
  std::thread run([&] { host.run(Duration::seconds(60)); });
  EXPECT_TRUE(console.hears("eye: open"));
  EXPECT_TRUE(eventually([&] { return writer->matched_readers() > 0; }));
  const std::vector<std::uint8_t> none = {0, 1, 0, 0, 7};  // one byte of eight
  writer->write(none);
  const std::string rejected =
      "eye: a sample on /value is no std_msgs/msg/Float64 and was thrown away; /diagnostics counts them";
  EXPECT_TRUE(console.hears(rejected));
  writer->write(none);
  host.finish({.ok = true, .reason = "that will do"}, true);
  run.join();
  EXPECT_TRUE(console.hears("bandwagon: the run ends: that will do"));
  EXPECT_EQ(console.count(rejected), 1);
}

}  // namespace
}  // namespace bw
