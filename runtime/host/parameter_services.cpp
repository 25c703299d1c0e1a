#include "runtime/host/parameter_services.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <rcl_interfaces/srv/describe_parameters.hpp>
#include <rcl_interfaces/srv/get_parameter_types.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>
#include <rcl_interfaces/srv/list_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters_atomically.hpp>

#include "runtime/ros/parameter_messages.hpp"

namespace bw {
namespace {

using namespace rcl_interfaces::srv;

/// What `answer` makes of each parameter asked for; nothing when one of them is unknown.
template <class Answer>
auto each_or_none(const LiveParameters& parameters, const std::vector<std::string>& names, Answer answer) {
  std::vector<decltype(answer(std::declval<LiveParameters::Parameter>()))> answers;
  for (const std::string& name : names) {
    const std::optional<LiveParameters::Parameter> parameter = parameters.find(name);
    if (!parameter) return decltype(answers){};
    answers.push_back(answer(*parameter));
  }
  return answers;
}

/// Empty: it was accepted.
rcl_interfaces::msg::SetParametersResult result_of(const std::string& refusal) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful(refusal.empty());
  result.reason(refusal);
  return result;
}

/// rcl_interfaces has no place for a default: it goes behind what a range cannot say.
void add_default(rcl_interfaces::msg::ParameterDescriptor& descriptor,
                 const std::vector<ParameterRow>& rows) {
  const auto row = std::ranges::find(rows, descriptor.name(), &ParameterRow::name);
  if (row == rows.end() || row->default_value.empty()) return;
  std::string& constraints = descriptor.additional_constraints();
  constraints += (constraints.empty() ? "default " : "; default ") + row->default_value;
}

void offer_reading(Setup& setup, const LiveParameters& parameters, const std::vector<ParameterRow>& rows) {
  const auto offer = [&setup]<class S>(const char* name, auto handle) {
    setup.service<S>(name, std::move(handle), nullptr, ServiceScope::node);
  };
  offer.operator()<GetParameters>("~/get_parameters", [&parameters](const auto& request, const Tick&) {
    GetParameters::Response response;
    response.values(each_or_none(parameters, request.names(),
                                 [](const auto& parameter) { return bw::to_message(parameter.value); }));
    return response;
  });
  offer.operator()<GetParameterTypes>(
      "~/get_parameter_types", [&parameters](const auto& request, const Tick&) {
        GetParameterTypes::Response response;
        response.types(each_or_none(parameters, request.names(), [](const auto& parameter) {
          return static_cast<std::uint8_t>(type_of(parameter.value));
        }));
        return response;
      });
  offer.operator()<DescribeParameters>(
      "~/describe_parameters", [&parameters, &rows](const auto& request, const Tick&) {
        DescribeParameters::Response response;
        response.descriptors(each_or_none(parameters, request.names(), [](const auto& parameter) {
          return bw::to_message(parameter.name, parameter.descriptor);
        }));
        for (auto& descriptor : response.descriptors()) add_default(descriptor, rows);
        return response;
      });
  offer.operator()<ListParameters>("~/list_parameters", [&parameters](const auto& request, const Tick&) {
    ListParameters::Response response;
    response.result(list_names(parameters.names(), request.prefixes(), request.depth()));
    return response;
  });
}

}  // namespace

void offer_parameter_services(Setup& setup, LiveParameters& parameters, const std::vector<ParameterRow>& rows,
                              OnParameterEvent on_event) {
  offer_reading(setup, parameters, rows);
  const auto tell = [on_event = std::move(on_event)](const Tick& tick,
                                                     const std::vector<NamedValue>& changed) {
    if (!changed.empty()) on_event(tick, changed);
  };
  setup.service<SetParameters>(
      "~/set_parameters",
      [&parameters, tell](const SetParameters::Request& request, const Tick& tick) {
        const auto outcome = parameters.change_each(from_messages(request.parameters()), tick);
        tell(tick, outcome.changed);
        SetParameters::Response response;
        for (const std::string& refusal : outcome.refusals) response.results().push_back(result_of(refusal));
        return response;
      },
      [](const std::string& reason) {
        SetParameters::Response response;
        response.results().push_back(result_of(reason));
        return response;
      },
      ServiceScope::node);
  setup.service<SetParametersAtomically>(
      "~/set_parameters_atomically",
      [&parameters, tell](const SetParametersAtomically::Request& request, const Tick& tick) {
        const auto outcome = parameters.change_all(from_messages(request.parameters()), tick);
        tell(tick, outcome.changed);
        SetParametersAtomically::Response response;
        response.result(result_of(outcome.refusals.front()));
        return response;
      },
      [](const std::string& reason) {
        SetParametersAtomically::Response response;
        response.result(result_of(reason));
        return response;
      },
      ServiceScope::node);
}

}  // namespace bw
