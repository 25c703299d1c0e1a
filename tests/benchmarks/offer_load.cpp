// Offers messages at a steady rate to whoever reads, for `bandwagon record` to take:
//   offer_load SIZE RATE SECONDS [best_effort]      bytes of a message, messages a second
// Sends to the topic /load from when a reader is there, and prints how much it was.
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "tests/interop/eventually.hpp"

int main(int argc, char** argv) {
  using std::chrono::steady_clock;
  if (argc < 4) {
    std::cerr << "offer_load SIZE RATE SECONDS [best_effort]\n";
    return 2;
  }
  const auto size = static_cast<std::size_t>(std::stoull(argv[1]));
  const double rate = std::stod(argv[2]);
  const auto count = static_cast<std::uint64_t>(rate * std::stod(argv[3]));
  bw::Qos qos = bw::Qos::standard();
  if (argc > 4 && std::string(argv[4]) == "best_effort") qos = bw::Qos::sensor();
  bw::dds::Participant participant(
      {.network = bw::dds::Network::from_environment(bw::dds::Transport::localhost)});
  const auto writer = participant.create_writer(
      {.topic = "rt/load", .type = "load_msgs::msg::dds_::Load_", .qos = qos, .user_data = {}});
  if (!bw::test::eventually([&] { return writer->matched_readers() > 0; })) {
    std::cerr << "nobody reads /load\n";
    return 1;
  }
  std::vector<std::uint8_t> cdr(size, 7);
  cdr[0] = cdr[2] = cdr[3] = 0;
  cdr[1] = 1;
  const auto start = steady_clock::now();
  std::uint64_t sent = 0;
  for (; sent < count; ++sent) {
    for (std::size_t i = 4; i < 12; ++i) cdr[i] = static_cast<std::uint8_t>(sent >> (8 * (i - 4)));
    std::this_thread::sleep_until(start + std::chrono::duration<double>(static_cast<double>(sent) / rate));
    writer->write(cdr);
  }
  const double took = std::chrono::duration<double>(steady_clock::now() - start).count();
  writer->wait_until_received(bw::Duration::milliseconds(5000));
  std::cout << sent << " messages of " << size << " bytes in " << took
            << " s: " << static_cast<double>(sent * size) * 1e-6 / took << " MB/s\n";
}
