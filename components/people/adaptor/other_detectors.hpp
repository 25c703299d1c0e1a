// Other detectors of people (people_msgs/People: cameras, mostly) beside the lasers. One that is silent is
// only missing.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <people_msgs/msg/people.hpp>

#include "components/people/adaptor/people_message.hpp"
#include "components/people/people_parameters.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw::people {

class OtherDetectors {
 public:
  /// `on_message` is called when one has come and waits.
  void listen(Setup& setup, const OtherDetectorOptions& options, std::function<void(const Tick&)> on_message);
  void set_options(const OtherDetectorOptions& options) { options_ = options; }

  /// What waits and is of `until` or before, in order of arrival: whatever the lasers saw by then is known.
  std::vector<HeardSet> take(Time until, Time now);

  std::uint64_t refusals() const { return refusals_; }
  /// What is wrong: nobody is heard, or not used; empty: nothing.
  std::string complaint(Time now) const;

 private:
  static constexpr std::size_t kMax = 8;
  static constexpr std::size_t kMaxPeople = 200;  // of a message

  struct Source {
    std::string topic;
    std::deque<people_msgs::msg::People> waiting;
    Complaint fault{};
    std::optional<Time> used;
  };
  void note(Source& source, const std::string& fault);

  OtherDetectorOptions options_;
  std::vector<Source> sources_;
  std::uint64_t refusals_ = 0;
  std::string odom_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Logger log_;
};

}  // namespace bw::people
