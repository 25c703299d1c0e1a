// A node with a service and parameters, for those who look at it from outside.
#pragma once

#include <string>

#include <std_srvs/srv/set_bool.hpp>

#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw::foxglove::test {

using std_srvs::srv::SetBool;

template <class M>
Bytes bytes_of(const M& message) {
  Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

struct ThingOptions {
  double gain = 1.0;
  int count = 3;
  void fields(auto& v) {
    v("gain", gain, {.min = 0, .max = 5});
    v("count", count, {.min = 0, .max = 100});
  }
};

/// The node /robot1/thing with a service, and parameters.
inline Graph thing() {
  Graph graph;
  graph.components.push_back(scripted({.name = "thing", .node_namespace = "/robot1"}, [](Setup& setup) {
    setup.parameters<ThingOptions>([](const ThingOptions&, const Tick&) {}, {"count"});
    setup.service<SetBool>("turn", [](const SetBool::Request& request, const Tick&) {
      SetBool::Response response;
      response.success(request.data());
      response.message(request.data() ? "on" : "off");
      return response;
    });
  }));
  return graph;
}

}  // namespace bw::foxglove::test
