// Compares what components write now with what they wrote in a recording, topic by topic, message by message.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/bag/bytes.hpp"
#include "runtime/base/time.hpp"

namespace bw::replay {

/// Which fields of a topic need not be equal to the bit. Paths without indexes: ranges, tracks.position.x.
struct Tolerances {
  std::map<std::string, std::map<std::string, double>> absolute;  ///< by topic and field; missing: exact
  std::map<std::string, std::vector<std::string>> left_out;       ///< fields that cannot repeat, by topic
};

/// The first place where a topic differs.
struct Difference {
  Time time;             ///< of the recorded message, or of the new one if none was recorded
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
  double largest = 0.0;       ///< difference of a number
  std::string largest_field;
  std::optional<Difference> first;

  [[nodiscard]] bool is_equal() const { return differing + missing + extra == 0; }
};

class OutputComparison {
 public:
  explicit OutputComparison(Tolerances tolerances) : tolerances_(std::move(tolerances)) {}

  /// A topic that takes part, of a type by its ROS name.
  void add_topic(const std::string& topic, const std::string& type);
  void expect(const std::string& topic, Time time, bag::BytesView cdr);
  void got(const std::string& topic, Time time, bag::BytesView cdr);
  /// What waits for its partner has none. Messages got at `end` or later may be more than were recorded: the recording
  /// may have stopped within that instant.
  void finish(Time end);

  [[nodiscard]] const std::map<std::string, TopicVerdict>& verdicts() const { return verdicts_; }
  /// The topic whose first difference is the earliest; nothing: all is equal.
  [[nodiscard]] std::optional<std::string> first_topic() const;
  /// Messages that had a partner.
  [[nodiscard]] std::uint64_t compared() const;

 private:
  struct Waiting {
    Time time;
    bag::Bytes cdr;
  };
  struct Pair {
    std::deque<Waiting> expected;
    std::deque<Waiting> got;
  };
  void match(const std::string& topic);
  void compare(const std::string& topic, const Waiting& recorded, const Waiting& replayed);

  Tolerances tolerances_;
  std::map<std::string, TopicVerdict> verdicts_;
  std::map<std::string, Pair> waiting_;
};

}  // namespace bw::replay
