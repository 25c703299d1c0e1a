// How a running graph looks to somebody who comes later, in seconds:
//   plain_newcomer                            until every node and each of the ends that it lists is known
//   plain_newcomer SECONDS                    what is known then, as `ros2 node list --no-daemon` looks after 0.5 s
//   plain_newcomer TOPIC TYPE COMMAND...      until the first sample of a topic, from the start of COMMAND on
#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/plain/node.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr std::chrono::milliseconds kPause{2};

int look_after(double seconds) {
  const auto start = Clock::now();
  plain::Node node("newcomer");
  bw::test::poll_until(
      start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)), kPause,
      [] { return false; });
  const auto ends = node.ends();
  const auto nodes = node.nodes();
  std::printf("%zu nodes, %zu ends after %.3f s\n", nodes.size(), ends.size(), since(start));
  return 0;
}

int know_everybody() {
  const auto start = Clock::now();
  plain::Node node("newcomer");
  // Whole when every listed end is known and nothing has changed for two seconds; told is when it became so.
  double whole_at = 0.0;
  std::size_t last_count = 0;
  const bool is_known = bw::test::poll_until(start + std::chrono::seconds(60), kPause, [&] {
    const auto ends = node.ends();
    const auto nodes = node.nodes();
    std::size_t listed = 0, known = 0;
    for (const plain::NodeInfo& info : nodes) {
      for (const auto* gids : {&info.readers, &info.writers}) {
        listed += gids->size();
        for (const plain::Gid& gid : *gids) known += ends.count(gid);
      }
    }
    const std::size_t count = ends.size() + listed;
    if (listed == 0 || known < listed || count != last_count) whole_at = since(start);
    last_count = count;
    if (since(start) - whole_at <= 2.0 || listed == 0) return false;
    std::printf("%zu nodes, %zu ends after %.3f s\n", nodes.size(), known, whole_at);
    return true;
  });
  return is_known ? 0 : 1;
}

int hear_first(const std::string& topic, const std::string& type, char** command) {
  plain::Node node("newcomer");
  plain::dds::DataReader* reader =
      node.create_reader({.topic = "rt" + topic, .type = type, .type_hash = {}, .depth = 1});
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execvp(command[0], command);
    _exit(127);
  }
  plain::Bytes sample;
  plain::dds::SampleInfo info;
  bool is_heard = false;
  bw::test::poll_until(Clock::time_point::max(), kPause, [&] {
    is_heard = bw::fast_dds::is_ok(reader->take_next_sample(&sample, &info));
    return is_heard || waitpid(child, nullptr, WNOHANG) == child;
  });
  if (!is_heard) return 1;
  std::printf("first of %s after %.3f s\n", topic.c_str(), since(start));
  kill(child, SIGINT);
  waitpid(child, nullptr, 0);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 3) return hear_first(argv[1], argv[2], argv + 3);
  return argc == 2 ? look_after(std::stod(argv[1])) : know_everybody();
}
