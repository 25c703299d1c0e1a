// The page and Foxglove for whoever wants to look at a run. It looks on from outside, through a participant
// of its own: a run in lock-step has the same bytes with it and without.
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "components/viewer/adaptor/page_server.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/component.hpp"
#include "runtime/dds/participant.hpp"

namespace bw::viewer {
namespace {

constexpr const char* kRefusal =
    "this run is in lock-step and takes nothing from outside; start it with --accept-inputs";

class ViewerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<web::ServerOptions>();
    options_.token_file = setup.file_parameter("token_file").string();
    options_.bag_folder = setup.file_parameter("bag_folder").string();
    const bool is_lockstep = setup.is_lockstep();
    robot_ = {.network = setup.network(),
              .node = "viewer_wire",
              .distro = setup.ros_distro() == RosDistro::humble ? RosDistro::humble : RosDistro::automatic,
              .looks_around = !is_lockstep,
              .refusal = setup.accepts_inputs() ? "" : kRefusal,
              .metadata = {{"clock", is_lockstep ? "lockstep" : "wall"},
                           {"accept_inputs", setup.accepts_inputs() ? "true" : "false"},
                           {"version", program_version()}}};
    if (!is_lockstep) log_ = setup.log();  // in lock-step a line of the log is a sample
  }

  void activate(const Tick&) override {
    server_ = std::make_unique<PageServer>(options_, robot_, log_);
    if (std::exchange(told_, server_->address()) == server_->address()) return;
    std::cout << invitation(told_) << std::endl;
  }
  void deactivate(const Tick&) override { server_.reset(); }

 private:
  web::ServerOptions options_;
  foxglove::WireRobotOptions robot_;
  Logger log_;
  std::string told_;
  std::unique_ptr<PageServer> server_;
};

BW_COMPONENT(ViewerComponent, "viewer")

}  // namespace
}  // namespace bw::viewer
