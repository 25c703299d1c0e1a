// at_once GATE COUNT: two participants that are made in two threads as soon as nobody holds the lock of the file
// GATE. Prints "ready" before that, and "complete" when each of both has a sample of every one of COUNT
// participants and sees the others; then waits for a signal.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "runtime/dds/participant.hpp"
#include "tests/interop/eventually.hpp"

namespace {

using namespace bw;

struct One {
  One()
      : participant({.network = dds::Network::from_environment(dds::Transport::localhost)}),
        reader(participant.create_reader(end(), [] {})),
        writer(participant.create_writer(end())) {
    writer->write({{0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0}});
  }
  static dds::EndpointOptions end() {
    return {.topic = "rt/at_once", .type = "std_msgs::msg::dds_::String_", .qos = Qos::tf_static()};
  }
  bool has(std::size_t count) {
    for (dds::Sample sample; reader->take(sample);) heard.insert(sample.writer);
    return heard.size() == count && participant.remote_participants().size() == count - 1;
  }

  dds::Participant participant;
  std::unique_ptr<dds::Reader> reader;
  std::unique_ptr<dds::Writer> writer;
  std::set<dds::Guid> heard;
};

int run(const char* gate, std::size_t count) {
  const int file = open(gate, O_RDONLY | O_CLOEXEC);
  if (file < 0) throw std::runtime_error(std::string(gate) + ": cannot be read");
  std::cout << "ready" << std::endl;
  flock(file, LOCK_SH);
  std::unique_ptr<One> first, second;
  std::thread beside([&] { first = std::make_unique<One>(); });
  second = std::make_unique<One>();
  beside.join();
  if (!test::eventually([&] { return first->has(count) && second->has(count); })) {
    std::cout << "heard " << first->heard.size() << " and " << second->heard.size() << ", sees "
              << first->participant.remote_participants().size() << " and "
              << second->participant.remote_participants().size() << std::endl;
    return 1;
  }
  std::cout << "complete" << std::endl;
  pause();
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  try {
    return run(arguments[1], std::strtoul(arguments[2], nullptr, 10));
  } catch (const std::exception& e) {
    std::cout << e.what() << std::endl;
    return 1;
  }
}
