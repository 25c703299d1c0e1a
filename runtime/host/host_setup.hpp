// Records what a component declares into its actor; connects nothing.
#pragma once

#include <string>
#include <vector>

#include "runtime/graph/graph.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

class Host;
class Rebinding;

class HostSetup final : public Setup {
 public:
  /// With `rebinding` a new instance declares the ends that the actor has already.
  HostSetup(Host& host, Actor& actor, const ComponentNode& node, Rebinding* rebinding = nullptr)
      : host_(host), actor_(actor), node_(node), rebinding_(rebinding) {}
  /// What is declared from now on belongs to the node, whatever becomes of its component.
  void declare_for_the_node() { of_node_ = true; }

  std::filesystem::path file_parameter(std::string_view key) const override;
  void every(Duration period, const std::string& name, TickHandler on_tick) override;
  std::string frame(std::string_view name) const override;
  std::uint64_t seed() const override;
  bool is_lockstep() const override;
  bool accepts_inputs() const override;
  void longest_callback(Duration time) override { actor_.longest_callback = time; }
  dds::Network network() const override;
  std::filesystem::path state_file(const std::string& name) const override;
  Keepsake keepsake(const std::string& name) const override;
  Writers& writers() override;
  RosDistro ros_distro() const override;
  Logger log() override;
  DiagnosticReporter& diagnostics() override { return actor_; }
  Failsafe failsafe(FailsafeRow row) override;
  std::function<void(bool, const std::string&)> finish_run() override;

 protected:
  std::shared_ptr<void> keep_part(std::function<std::shared_ptr<void>(Setup&)> make) override;
  OutputPort* add_output(const std::string& topic, const MessageType& type, const Qos& qos,
                         bool command) override;
  void add_input(const std::string& topic, const MessageType& type, const Qos& qos, InputKind kind, Need need,
                 SampleHandler handler) override;
  ServicePort& add_service(const std::string& name, const ServiceType& type, ServiceScope scope) override;
  void set_handler(ServicePort& port, RequestHandler handler) override;
  ActionPort& add_action(const std::string& name, const ActionType& type) override;
  void set_action(ActionPort& port, ActionHandler handler) override;
  ClientPort* add_client(const std::string& name, const ServiceType& type, Need need) override;
  const ConfigNode& parameter_section() const override { return node_.parameters; }
  std::string parameter_path() const override { return node_.name; }
  const ConfigNode& shared_section(std::string_view section) const override;
  void comes_to_rest_within(std::string_view section, Duration time) override;
  void keep_parameters(ParameterReport report, ParameterDeclaration declaration) override;
  void keep_shared_parameters(std::string_view section, ParameterReport report, ParameterSet values) override;

 private:
  Host& host_;
  Actor& actor_;
  const ComponentNode& node_;
  Rebinding* rebinding_ = nullptr;
  bool of_node_ = false;
  bool of_part_ = false;
};

}  // namespace bw
