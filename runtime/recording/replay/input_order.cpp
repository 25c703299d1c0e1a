#include "runtime/recording/replay/input_order.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "runtime/recording/bag/known_type.hpp"
#include "runtime/recording/bag/message_stamp.hpp"

namespace bw::replay {
namespace {

/// Of a replay, against the budget: a short one costs its start.
constexpr Duration kLeastCost = Duration::milliseconds(5'000);

/// How far around a difference its inputs are looked for.
Duration reach(const FirstDifference& difference) { return std::max(difference.period, kCloseTogether); }

/// What was delayed, or has something behind it, stays where it is: so nothing waits for itself.
bool is_settled(const std::vector<Delay>& delays, const Exchange& exchange) {
  return std::ranges::any_of(exchange.delays, [&](const Delay& wanted) {
    return std::ranges::any_of(delays, [&](const Delay& delay) {
      return delay.message == wanted.message || delay.behind == wanted.message;
    });
  });
}

/// The first of them behind the last, and the last before the first: the same where nothing is between.
void add_both(std::vector<Exchange>& exchanges, std::span<const RecordedInput> inputs) {
  const RecordedInput& first = inputs.front();
  const RecordedInput& last = inputs.back();
  exchanges.push_back({first, last, {{.message = first.number, .behind = last.number}}});
  if (inputs.size() == 2) return;
  Exchange& before = exchanges.emplace_back(Exchange{last, first, {}});
  for (const RecordedInput& input : inputs.first(inputs.size() - 1))
    before.delays.push_back({.message = input.number, .behind = last.number});
}

}  // namespace

std::vector<Exchange> exchanges_around(const FirstDifference& difference,
                                       const std::vector<RecordedInput>& inputs) {
  std::vector<Exchange> exchanges;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t k = i + 1; k < inputs.size(); ++k) {
      if (inputs[i].topic != inputs[k].topic && inputs[k].log_time - inputs[i].log_time <= kCloseTogether)
        add_both(exchanges, std::span(inputs).subspan(i, k - i + 1));
    }
  }
  const auto rank = [&](const Exchange& exchange) {
    const bool is_answered =
        exchange.moved.stamp == difference.stamp || exchange.past.stamp == difference.stamp;
    return std::tuple(!is_answered, exchange.apart().nanoseconds);
  };
  std::ranges::stable_sort(exchanges, {}, rank);
  return exchanges;
}

std::vector<RecordedInput> inputs_between(const bag::Bag& recording, const std::set<std::string>& topics,
                                          Time from, Time to) {
  std::vector<const TypeDescription*> types;
  for (const bag::BagTopic& topic : recording.topics()) types.push_back(bag::known_type(topic).type);
  std::vector<RecordedInput> inputs;
  const auto messages = recording.messages({});
  bag::BagMessage message;
  std::uint64_t number = 0;
  for (bag::Step step; (step = messages->next(message)) != bag::Step::end;) {
    if (step != bag::Step::message) continue;
    if (message.log_time > to) break;
    const std::uint64_t own = number++;
    const std::string& topic = recording.topics()[message.topic].name;
    if (message.log_time < from || !topics.contains(topic)) continue;
    const TypeDescription* type = types[message.topic];
    const bool has_stamp = type != nullptr && bag::begins_with_stamp(*type);
    inputs.push_back(
        {.number = own,
         .topic = topic,
         .log_time = message.log_time,
         .stamp = has_stamp ? bag::stamp_of(message.data).value_or(message.log_time) : message.log_time});
  }
  return inputs;
}

bool lacks_its_input(const bag::Bag& recording, const std::set<std::string>& topics,
                     const FirstDifference& difference) {
  std::set<std::string> all = topics;
  all.insert(difference.stamped_topic);
  std::map<std::string, std::set<Time>> stamps;
  for (const RecordedInput& message : inputs_between(recording, all, recording.start(), recording.end()))
    stamps[message.topic].insert(message.stamp);
  const std::set<Time> outputs = std::exchange(stamps[difference.stamped_topic], {});
  double best_share = 0.0;
  bool is_there = true;
  for (const auto& [topic, own] : stamps) {
    const auto answered = std::ranges::count_if(own, [&](Time stamp) { return outputs.contains(stamp); });
    const double share =
        static_cast<double>(answered) / static_cast<double>(std::max(own.size(), std::size_t{1}));
    if (2 * answered <= std::ssize(outputs) || share <= best_share) continue;
    best_share = share;
    is_there = own.contains(difference.stamp);
  }
  return !is_there;
}

OrderVerdict explain_by_order(const bag::Bag& recording, const std::set<std::string>& topics,
                              const FirstDifference& first, Duration budget, const TryOrder& replay_with) {
  OrderVerdict verdict{.left = first};
  std::vector<Delay> delays;
  Duration spent{};
  while (verdict.left) {
    const FirstDifference difference = *verdict.left;
    const Duration around = reach(difference);
    const Time end = difference.time + around + around;
    verdict.tried = 0;
    verdict.close.clear();
    verdict.lacks_input = lacks_its_input(recording, topics, difference);
    if (verdict.lacks_input) return verdict;
    verdict.close = exchanges_around(
        difference, inputs_between(recording, topics, difference.time - around, difference.time + around));
    std::erase_if(verdict.close, [&](const Exchange& exchange) { return is_settled(delays, exchange); });
    const auto found = std::ranges::find_if(verdict.close, [&](const Exchange& exchange) {
      if (verdict.tried + verdict.taken.size() > 0 && spent > budget) return false;
      ++verdict.tried;
      spent = spent + std::max(end - recording.start(), kLeastCost);
      std::vector<Delay> with = delays;
      with.insert(with.end(), exchange.delays.begin(), exchange.delays.end());
      const auto next = replay_with(with, end);
      if (next && next->time <= difference.time) return false;
      delays = std::move(with);
      return true;
    });
    if (found == verdict.close.end()) return verdict;
    verdict.taken.push_back(*found);
    verdict.left = replay_with(delays, std::nullopt);
    spent = spent + (recording.end() - recording.start());
  }
  verdict.close.clear();
  verdict.tried = 0;
  return verdict;
}

}  // namespace bw::replay
