#include "components/people/adaptor/other_detectors.hpp"

#include <utility>

#include "runtime/stamps.hpp"

namespace bw::people {

void OtherDetectors::listen(Setup& setup, const OtherDetectorOptions& options,
                            std::function<void(const Tick&)> on_message) {
  options_ = options;
  odom_frame_ = setup.frame("odom");
  transforms_ = setup.transforms();
  log_ = setup.log();
  for (const std::string& topic : options.people_topics) sources_.push_back({.topic = topic});
  for (std::size_t i = 0; i < sources_.size(); ++i)
    setup.input<people_msgs::msg::People>(
        sources_[i].topic, Qos::sensor(),
        [this, i, on_message](const people_msgs::msg::People& message, const Tick& tick) {
          Source& source = sources_[i];
          if (source.waiting.size() == kMax) source.waiting.pop_front();
          source.waiting.push_back(message);
          on_message(tick);
        },
        Need::optional);
}

std::vector<HeardSet> OtherDetectors::take(Time until, Time now) {
  std::vector<HeardSet> taken;
  for (Source& source : sources_) {
    while (!source.waiting.empty() && from_stamp(source.waiting.front().header().stamp()) <= until) {
      const people_msgs::msg::People& message = source.waiting.front();
      ReadPeople read = read_people(message, now, options_.kPeopleTimeout, odom_frame_, *transforms_);
      if (message.people().size() > kMaxPeople) read.fault = "it tells of more than 200 people";
      note(source, read.fault);
      source.waiting.pop_front();
      if (!read.fault.empty()) continue;
      source.used = now;
      for (HeardPerson& person : read.heard.people)
        if (person.reliability == 0.0) person.reliability = options_.kUntoldReliability;
      taken.push_back(std::move(read.heard));
    }
    // What is of the future waits for its time, but not for ever.
    std::erase_if(source.waiting, [&](const people_msgs::msg::People& message) {
      const bool is_far =
          from_stamp(message.header().stamp()) > now + Duration::seconds(options_.kPeopleTimeout);
      if (is_far) note(source, "its stamp is not of now");
      return is_far;
    });
  }
  return taken;
}

void OtherDetectors::note(Source& source, const std::string& fault) {
  if (!fault.empty()) ++refusals_;
  if (!source.fault.is_news(fault)) return;
  if (fault.empty())
    log_.info("people of '{}' are used again", source.topic);
  else
    log_.warn("people of '{}' are not used: {}", source.topic, fault);
}

std::string OtherDetectors::complaint(Time now) const {
  for (const Source& source : sources_) {
    if (source.fault) return "people of '" + source.topic + "' are not used: " + source.fault.what();
    if (!source.used || now - *source.used > Duration::seconds(options_.kPeopleSilence))
      return "nobody is heard on '" + source.topic + "'";
  }
  return {};
}

}  // namespace bw::people
