#include "runtime/recording/bag/bag_report.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

#include "runtime/recording/bag/known_type.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::bag {
namespace {

/// Of what a hostile bag claims, too: differences of its times may be more than Duration holds.
Duration difference(Duration a, Duration b) {
  std::int64_t result = 0;
  if (__builtin_sub_overflow(a.nanoseconds, b.nanoseconds, &result))
    return {a.nanoseconds < 0 ? std::numeric_limits<std::int64_t>::min()
                              : std::numeric_limits<std::int64_t>::max()};
  return {result};
}

class Examination {
 public:
  explicit Examination(const Bag& bag, Duration jump) : jump_(jump) {
    for (const BagTopic& topic : bag.topics()) {
      const KnownType known = known_type(topic);
      report_.topics.push_back(
          {.name = topic.name, .type = topic.type, .writer = topic.writer, .difference = known.why});
      types_.push_back(known.type);
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
  /// With what the bag promised: a message that is in its counts and not in its chunks is lost.
  BagReport finish(const Bag& bag) {
    std::uint64_t read = 0;
    for (const TopicReport& topic : report_.topics) read += topic.count;
    if (report_.faults.empty() && read != bag.message_count()) {
      report_.faults.push_back({{},
                                0,
                                std::to_string(bag.message_count()) + " messages are promised and " +
                                    std::to_string(read) + " are there"});
    }
    std::ranges::copy(bag.verify(), std::back_inserter(report_.faults));
    return std::move(report_);
  }

 private:
  void compare_clocks(const BagMessage& m, TopicReport& topic) {
    std::optional<Time>& last_stamp = last_stamps_[m.topic];
    if (last_stamp) {
      if (m.publish_time < *last_stamp && topic.falling++ == 0) topic.first_falling = m.log_time;
      const Duration apart = difference(m.log_time - topic.last, m.publish_time - *last_stamp);
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
  return examination.finish(bag);
}

}  // namespace bw::bag
