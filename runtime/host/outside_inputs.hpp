// What other participants send into a run in lock-step. Requests that only ask are answered between events.
// What changes something is refused, or accepted: then it is published at the beginning of an instant by a
// component of the run, so that it is hashed, recorded and replayed as every other message. A request is
// published as the event that ROS 2's service introspection makes of it.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runtime/host/actor.hpp"
#include "runtime/host/outside.hpp"

namespace bw {

class OutsideInputs final : public Outside {
 public:
  static constexpr const char* kNode = "outside";
  static constexpr const char* kRefusal =
      "this run is in lock-step and takes nothing from outside; start it with --accept-inputs";

  /// A topic that components hear and nobody in the graph says.
  struct Topic {
    std::string name;
    MessageType type;
    Qos qos;
  };

  /// `warn` says what was refused where no reply can.
  OutsideInputs(bool accepts, std::function<void(const std::string&)> warn)
      : accepts_(accepts), warn_(std::move(warn)) {}

  static std::vector<Topic> topics_of(const std::vector<std::unique_ptr<Actor>>& actors);
  /// Through which what is accepted enters. It must not outlive this.
  std::unique_ptr<Component> make_component(std::vector<Topic> topics);
  /// Opens the ears. Services of `actors` have their ends by now.
  void connect(dds::Participant& participant, const std::vector<Topic>& topics,
               const std::vector<Actor*>& actors);
  /// Something has entered.
  bool was_used() const { return was_used_; }

  void has_news() override { has_news_ = true; }
  void look(Time now) override;
  void enter(Time now) override;

 private:
  class Mouth;
  struct Ear {
    std::string topic;
    std::unique_ptr<dds::Reader> reader;
  };
  /// What waits for its instant: a request of `service`, or a message of `topic`.
  struct Kept {
    ServiceEnd* service = nullptr;
    std::string topic;
    ServiceEnd::Request request;
  };

  void listen(Ear& ear);
  void tell_refusal(const std::string& what, const dds::Guid& sender);

  bool accepts_;
  std::function<void(const std::string&)> warn_;
  std::atomic<bool> has_news_ = false;
  bool was_used_ = false;
  std::map<std::string, OutputPort*> ports_;  ///< by absolute topic
  std::vector<ServiceEnd*> services_;
  std::vector<Ear> ears_;
  std::vector<Kept> kept_;
  std::set<std::pair<std::string, dds::Guid>> refused_;
};

}  // namespace bw
