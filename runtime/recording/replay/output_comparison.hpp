// Compares what components write now with what they wrote in a recording, topic by topic, message by message.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "runtime/base/time.hpp"
#include "runtime/host/sample_hash.hpp"
#include "runtime/recording/bag/bytes.hpp"
#include "runtime/recording/replay/tolerances.hpp"

namespace bw::replay {

/// Which recorded message belongs to which new one.
enum class Pairing {
  in_order,  ///< the first to the first: of a run in virtual time; times must be equal
  by_stamp,  ///< the nearest within half the topic's usual period, by the message's own stamp where it has one: of a run in
             ///< real time; new messages before the topic's first recorded one or after its last do not count
};

/// The first place where a topic differs.
struct Difference {
  Time time;             ///< of the recorded message, or of the new one if none was recorded
  Time stamp;            ///< its own, else `time`
  std::string field;     ///< empty: a message is missing or too many, or the times differ
  std::string recorded;  ///< as text
  std::string replayed;
};

struct TopicVerdict {
  std::string type;
  std::uint64_t equal = 0;
  std::uint64_t differing = 0;
  std::uint64_t missing = 0;  ///< recorded, not written now
  std::uint64_t extra = 0;    ///< written now, not recorded
  Duration period{};          ///< usual time between recorded messages, by_stamp; 0: fewer than two
  double apart = 0.0;         ///< largest time between the two of a pair, by_stamp [s]
  double largest = 0.0;       ///< difference of a number
  std::string largest_field;
  std::optional<Difference> first;

  [[nodiscard]] bool is_equal() const { return differing + missing + extra == 0; }
};

class OutputComparison {
 public:
  OutputComparison(Pairing pairing, Tolerances tolerances)
      : pairing_(pairing), tolerances_(std::move(tolerances)) {}

  /// A topic that takes part, of a type by its ROS name.
  void add_topic(const std::string& topic, const std::string& type);
  void expect(const std::string& topic, Time time, bag::BytesView cdr);
  void got(const std::string& topic, Time time, bag::BytesView cdr);
  /// What waits for its partner has none. Messages got at `end` or later may be more than were recorded: the
  /// recording may have stopped within that instant.
  void finish(Time end);

  [[nodiscard]] const std::map<std::string, TopicVerdict>& verdicts() const { return verdicts_; }
  /// The topic whose first difference is the earliest; nothing: all is equal.
  [[nodiscard]] std::optional<std::string> first_topic() const;
  /// Messages that had a partner.
  [[nodiscard]] std::uint64_t compared() const;
  /// SHA-256 over the new messages, in the order they were written.
  [[nodiscard]] std::string sha256() const { return hash_.hex(); }

 private:
  struct Waiting {
    Time time;   ///< component clock
    Time stamp;  ///< its own, else `time`
    bag::Bytes cdr;
  };
  struct Pair {
    std::deque<Waiting> expected;
    std::deque<Waiting> got;
  };
  Waiting waiting(const std::string& topic, Time time, bag::BytesView cdr) const;
  void match_in_order(const std::string& topic);
  void match_by_stamp(const std::string& topic, Time end);
  void missing(TopicVerdict& verdict, const Waiting& recorded);
  void extra(TopicVerdict& verdict, const Waiting& replayed, Time end);
  void compare(const std::string& topic, const Waiting& recorded, const Waiting& replayed);

  Pairing pairing_;
  Tolerances tolerances_;
  SampleHash hash_;
  std::map<std::string, TopicVerdict> verdicts_;
  std::map<std::string, Pair> waiting_;
};

}  // namespace bw::replay
