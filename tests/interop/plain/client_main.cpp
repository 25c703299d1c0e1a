// plain_client SERVICE TYPE HEX: asks once when the service is ready, prints "asked", then the reply in
// hexadecimal.
#include <chrono>
#include <iostream>
#include <optional>

#include "tests/interop/eventually.hpp"
#include "tests/interop/plain/service.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  plain::Node node("plain_client");
  plain::Client client(node, argv[1], {argv[2], "", ""});
  const auto wait_for = [](auto seen) {
    constexpr std::chrono::milliseconds kPause{2};
    return bw::test::poll_until(std::chrono::steady_clock::time_point::max(), kPause, seen);
  };
  wait_for([&] { return client.is_ready(); });
  const std::int64_t asked = client.send(plain::from_hex(argv[3]));
  std::cout << "asked" << std::endl;
  std::optional<plain::Bytes> reply;
  wait_for([&] { return (reply = client.take(asked)).has_value(); });
  std::cout << plain::to_hex(*reply) << std::endl;
  return 0;
}
