// viewer_load: puts a load of many clients on a running viewer and prints as JSON what they got. On the
// robot's ROS_DOMAIN_ID.
#include <cstdio>
#include <iostream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "tests/page/load/load.hpp"

int main(int argc, char** argv) {
  bw::test::LoadOptions options;
  CLI::App app("Many clients of a running viewer", "viewer_load");
  app.add_option("--port", options.port, "of the viewer, on 127.0.0.1");
  app.add_option("--healthy", options.healthy, "clients that read whatever comes");
  app.add_option("--slow", options.slow, "clients that read one byte a second");
  app.add_option("--flapping", options.flapping, "clients that open and close");
  app.add_option("--flaps", options.flaps_per_second, "how often each of them does so in a second");
  app.add_option("--seconds", options.seconds, "how long");
  app.add_option("--topics", options.topics, "that all subscribe to")->delimiter(',');
  app.add_option("--robot", options.robot, "id of the process whose memory is looked at");
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << to_json(bw::test::put_load(options)).dump(2) << "\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
