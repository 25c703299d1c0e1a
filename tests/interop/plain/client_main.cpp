// plain_client SERVICE TYPE HEX: asks once when the service is ready, prints "asked", then the reply in hexadecimal.
#include <cstdio>
#include <iostream>
#include <thread>

#include "tests/interop/plain/service.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  plain::Node node("plain_client");
  plain::Client client(node, argv[1], {argv[2], "", ""});
  while (!client.is_ready()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const std::int64_t asked = client.send(plain::from_hex(argv[3]));
  std::cout << "asked" << std::endl;
  for (;;) {
    if (const auto reply = client.take(asked)) {
      std::cout << plain::to_hex(*reply) << std::endl;
      return 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}
