#include "runtime/bag/bag_report.hpp"

#include <algorithm>
#include <optional>

#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::bag {
namespace {

/// The description of a type that is built in and the same as the recorded one.
const TypeDescription* known_type(const BagTopic& topic) {
  const TypeDescription* type = topic.serialization_format == "cdr" ? find_type(topic.type) : nullptr;
  if (type == nullptr || topic.type_hash.empty() || topic.type_hash == type->type_hash) return type;
  return nullptr;
}

class Examination {
 public:
  explicit Examination(const Bag& bag, Duration jump) : jump_(jump) {
    for (const BagTopic& topic : bag.topics()) {
      report_.topics.push_back({.name = topic.name, .type = topic.type});
      types_.push_back(known_type(topic));
    }
    last_stamps_.resize(types_.size());
    report_.faults = bag.faults();
  }

  void take(const BagMessage& m) {
    TopicReport& topic = report_.topics[m.topic];
    if (topic.count == 0) {
      topic.first = m.log_time;
    } else if (m.log_time - topic.last > topic.longest_gap) {
      topic.longest_gap = m.log_time - topic.last;
      topic.longest_gap_at = topic.last;
    }
    compare_clocks(m, topic);
    topic.last = m.log_time;
    ++topic.count;
    topic.bytes += m.data.size();
    std::string error;
    if (types_[m.topic] != nullptr && !validate(*types_[m.topic], m.data, &error)) {
      if (topic.malformed++ == 0) topic.first_malformed = std::move(error);
    }
  }
  void take(const BagFault& fault) { report_.faults.push_back(fault); }
  BagReport finish() { return std::move(report_); }

 private:
  void compare_clocks(const BagMessage& m, TopicReport& topic) {
    std::optional<Time>& last_stamp = last_stamps_[m.topic];
    if (last_stamp) {
      if (m.publish_time < *last_stamp && topic.falling++ == 0) topic.first_falling = m.log_time;
      const Duration apart = (m.log_time - topic.last) - (m.publish_time - *last_stamp);
      // One jump is seen by every topic: those within the time of a jump are one.
      const bool is_new = report_.clock_jumps.empty() || m.log_time - report_.clock_jumps.back().at > jump_;
      if ((apart > jump_ || apart < jump_ * -1) && is_new) report_.clock_jumps.push_back({m.log_time, apart});
    }
    last_stamp = m.publish_time;
  }

  Duration jump_;
  BagReport report_;
  std::vector<const TypeDescription*> types_;
  std::vector<std::optional<Time>> last_stamps_;
};

}  // namespace

double TopicReport::rate() const {
  const double span = (last - first).to_seconds();
  return count < 2 || span <= 0.0 ? 0.0 : static_cast<double>(count - 1) / span;
}

bool BagReport::is_sound() const {
  return faults.empty() && clock_jumps.empty() && std::ranges::all_of(topics, [](const TopicReport& topic) {
           return topic.falling == 0 && topic.malformed == 0;
         });
}

BagReport examine(const Bag& bag, Duration jump) {
  Examination examination(bag, jump);
  const auto messages = bag.messages({});
  BagMessage message;
  for (Step step = messages->next(message); step != Step::end; step = messages->next(message)) {
    if (step == Step::damaged) {
      examination.take(messages->fault());
    } else {
      examination.take(message);
    }
  }
  return examination.finish();
}

}  // namespace bw::bag
