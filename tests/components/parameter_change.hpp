// Parameters of a node changed in the middle of a run, over its own service.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <rcl_interfaces/srv/set_parameters.hpp>

#include "runtime/component.hpp"
#include "runtime/ros/parameter_messages.hpp"

namespace bw {

/// Once, `at` [s] after the start of the run. `refusals` gets a reason for each, empty where it was accepted,
/// and must outlive the run.
inline void change_parameters(Setup& setup, const std::string& node, double at,
                              const std::vector<NamedValue>& parameters, std::vector<std::string>& refusals) {
  using rcl_interfaces::srv::SetParameters;
  SetParameters::Request request;
  for (const NamedValue& parameter : parameters) request.parameters().push_back(to_message(parameter));
  setup.every(
      Duration::seconds(at), "change",
      [request, &refusals, client = setup.client<SetParameters>(node + "/set_parameters")](const Tick& tick) {
        if (tick.sequence > 0) return;
        client.call(request, Duration::milliseconds(500),
                    [&refusals](const SetParameters::Response* response, const Tick&) {
                      if (response == nullptr) return refusals.push_back("no answer");
                      for (const auto& result : response->results()) refusals.push_back(result.reason());
                    });
      });
}

}  // namespace bw
