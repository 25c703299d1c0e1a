// Whether a difference comes from the order of inputs. A bag of real time holds when its recorder heard each
// message. A component may have taken two that arrived close together in the other order: the bag does not
// tell. So other orders are tried.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/replay/reordered_messages.hpp"

namespace bw::replay {

/// Inputs that arrived further apart than this are taken in their order.
constexpr Duration kCloseTogether = Duration::milliseconds(50);

/// An input as the bag has it.
struct RecordedInput {
  std::uint64_t number = 0;  ///< of the message in the bag, from 0
  std::string topic;
  Time log_time;
  Time stamp;  ///< its own, else log_time
};

/// An input taken on the other side of one of another topic.
struct Exchange {
  RecordedInput moved;
  RecordedInput past;  ///< what it comes directly behind; directly before, if `past` comes first in the bag
  std::vector<Delay> delays;  ///< that make it so

  [[nodiscard]] bool is_after() const { return moved.number < past.number; }
  [[nodiscard]] Duration apart() const {
    return is_after() ? past.log_time - moved.log_time : moved.log_time - past.log_time;
  }
};

/// The earliest difference of a replay.
struct FirstDifference {
  std::string topic;
  Time time;  ///< log time of the recorded message
  std::string
      stamped_topic;  ///< one whose messages carry a stamp and that differs first within half a period
  Time stamp;         ///< of its message
  Duration period;    ///< usual time between messages of `topic`; 0: not known
};

/// Orders in which `inputs` (in the bag's order) may have been taken: pairs of two topics, kCloseTogether or
/// less apart. The likeliest come first: those with an input of the difference's own stamp, which is what it
/// answers, then the closest.
[[nodiscard]] std::vector<Exchange> exchanges_around(const FirstDifference& difference,
                                                     const std::vector<RecordedInput>& inputs);

/// Messages of these topics in a span of log times, both ends included.
[[nodiscard]] std::vector<RecordedInput> inputs_between(const bag::Bag& recording,
                                                        const std::set<std::string>& topics, Time from,
                                                        Time to);

/// Most messages of the stamped topic carry the stamp of a message of one input, the one of which the
/// greatest share is answered so; and it has none of that stamp in the bag. The recorder did not hear it, and
/// no order of the others makes up for it.
[[nodiscard]] bool lacks_its_input(const bag::Bag& recording, const std::set<std::string>& topics,
                                   const FirstDifference& difference);

/// What was found.
struct OrderVerdict {
  std::vector<Exchange> taken;  ///< with all of these, what differed at first is equal
  std::vector<Exchange>
      close;  ///< around the first difference that is left: they may have been taken in another order
  std::size_t tried = 0;                ///< so many of `close`, from its beginning: none makes it equal
  bool lacks_input = false;             ///< what is left answers an input that is not in the bag
  std::optional<FirstDifference> left;  ///< nothing: all is equal with `taken`
};

/// Replays to a log time with these delays and tells the first difference.
using TryOrder =
    std::function<std::optional<FirstDifference>(const std::vector<Delay>& delays, std::optional<Time> end)>;

/// Explains `first`, then what differs first with that order, and so on, while the virtual time replayed
/// stays below `budget`; at least one exchange is tried.
[[nodiscard]] OrderVerdict explain_by_order(const bag::Bag& recording, const std::set<std::string>& topics,
                                            const FirstDifference& first, Duration budget,
                                            const TryOrder& replay_with);

}  // namespace bw::replay
