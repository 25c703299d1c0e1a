#include "runtime/recording/replay/output_comparison.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runtime/recording/bag/message_stamp.hpp"
#include "runtime/recording/replay/message_comparison.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::replay {
namespace {

std::string time_text(Time time) { return fmt::format("{:.9f} s", time.to_seconds()); }

/// Half the median time between two stamps; nothing of less than two messages.
template <class Messages>
std::optional<Duration> half_period(const Messages& messages) {
  std::vector<std::int64_t> gaps;
  for (std::size_t i = 1; i < messages.size(); ++i)
    gaps.push_back((messages[i].stamp - messages[i - 1].stamp).nanoseconds);
  if (gaps.empty()) return std::nullopt;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  return Duration{*middle / 2};
}

Duration between(Time a, Time b) { return a < b ? b - a : a - b; }

}  // namespace

void OutputComparison::add_topic(const std::string& topic, const std::string& type) {
  verdicts_[topic].type = type;
}

OutputComparison::Waiting OutputComparison::waiting(const std::string& topic, Time time,
                                                    bag::BytesView cdr) const {
  Waiting message{time, time, {cdr.begin(), cdr.end()}};
  const auto verdict = verdicts_.find(topic);
  const TypeDescription* type = verdict == verdicts_.end() ? nullptr : find_type(verdict->second.type);
  if (type != nullptr && bag::begins_with_stamp(*type)) message.stamp = bag::stamp_of(cdr).value_or(time);
  return message;
}

void OutputComparison::expect(const std::string& topic, Time time, bag::BytesView cdr) {
  waiting_[topic].expected.push_back(waiting(topic, time, cdr));
  if (pairing_ == Pairing::in_order) match_in_order(topic);
}

void OutputComparison::got(const std::string& topic, Time time, bag::BytesView cdr) {
  hash_.add(topic, time, cdr);
  waiting_[topic].got.push_back(waiting(topic, time, cdr));
  if (pairing_ == Pairing::in_order) match_in_order(topic);
}

void OutputComparison::match_in_order(const std::string& topic) {
  Pair& pair = waiting_[topic];
  while (!pair.expected.empty() && !pair.got.empty()) {
    compare(topic, pair.expected.front(), pair.got.front());
    pair.expected.pop_front();
    pair.got.pop_front();
  }
}

void OutputComparison::match_by_stamp(const std::string& topic, Time end) {
  TopicVerdict& verdict = verdicts_[topic];
  Pair& pair = waiting_[topic];
  std::ranges::stable_sort(pair.expected, {}, &Waiting::stamp);
  std::ranges::stable_sort(pair.got, {}, &Waiting::stamp);
  // Processes of a real-time run start and end one after the other: outside of what a topic holds, its writer
  // did not run.
  if (!pair.expected.empty()) {
    const Duration margin = half_period(pair.expected).value_or(Duration{});
    const Time first = pair.expected.front().stamp - margin;
    const Time last = pair.expected.back().stamp + margin;
    std::erase_if(pair.got, [&](const Waiting& w) { return w.stamp < first || w.stamp > last; });
  }
  const std::optional<Duration> limit = half_period(pair.expected);
  if (limit) verdict.period = *limit + *limit;
  auto recorded = pair.expected.begin();
  auto replayed = pair.got.begin();
  while (recorded != pair.expected.end() && replayed != pair.got.end()) {
    const Duration apart = between(recorded->stamp, replayed->stamp);
    const auto is_nearer = [&](const auto& a, const auto& b) { return between(a->stamp, b->stamp) < apart; };
    const bool is_far = limit && apart > *limit;
    const auto next_recorded = std::next(recorded);
    const auto next_replayed = std::next(replayed);
    if (is_far ? replayed->stamp < recorded->stamp
               : next_replayed != pair.got.end() && is_nearer(recorded, next_replayed)) {
      extra(verdict, *replayed++, end);
    } else if (is_far || (next_recorded != pair.expected.end() && is_nearer(next_recorded, replayed))) {
      missing(verdict, *recorded++);
    } else {
      verdict.apart = std::max(verdict.apart, apart.to_seconds());
      compare(topic, *recorded++, *replayed++);
    }
  }
  pair.expected.erase(pair.expected.begin(), recorded);
  pair.got.erase(pair.got.begin(), replayed);
}

void OutputComparison::compare(const std::string& topic, const Waiting& recorded, const Waiting& replayed) {
  TopicVerdict& verdict = verdicts_[topic];
  TopicTolerances tolerances = tolerances_[topic];
  const bool by_stamp = pairing_ == Pairing::by_stamp;
  // What pairs are made by is not held against them.
  if (by_stamp && recorded.stamp != replayed.stamp)
    tolerances.left_out.insert(tolerances.left_out.end(), {"header.stamp", "stamp"});
  const MessageDifference difference =
      compare_messages(find_type(verdict.type), recorded.cdr, replayed.cdr, tolerances);
  if (difference.largest > verdict.largest) {
    verdict.largest = difference.largest;
    verdict.largest_field = difference.largest_field;
  }
  std::optional<Difference> first;
  if (!by_stamp && recorded.time != replayed.time) {
    first = {recorded.time, recorded.stamp, "", time_text(recorded.time), time_text(replayed.time)};
  } else if (difference.first) {
    first = {recorded.time, recorded.stamp, difference.first->field, difference.first->recorded,
             difference.first->replayed};
  }
  ++(first ? verdict.differing : verdict.equal);
  if (!verdict.first) verdict.first = std::move(first);
}

void OutputComparison::missing(TopicVerdict& verdict, const Waiting& recorded) {
  ++verdict.missing;
  if (!verdict.first) verdict.first = Difference{recorded.time, recorded.stamp, "", "a message", "none"};
}

void OutputComparison::extra(TopicVerdict& verdict, const Waiting& replayed, Time end) {
  if (replayed.time >= end) return;
  ++verdict.extra;
  if (!verdict.first) verdict.first = Difference{replayed.time, replayed.stamp, "", "none", "a message"};
}

void OutputComparison::finish(Time end) {
  for (auto& [topic, pair] : waiting_) {
    if (pairing_ == Pairing::by_stamp) match_by_stamp(topic, end);
    TopicVerdict& verdict = verdicts_[topic];
    for (const Waiting& recorded : pair.expected) missing(verdict, recorded);
    for (const Waiting& replayed : pair.got) extra(verdict, replayed, end);
  }
  waiting_.clear();
}

std::optional<std::string> OutputComparison::first_topic() const {
  std::optional<std::string> first;
  for (const auto& [topic, verdict] : verdicts_) {
    if (verdict.first && (!first || verdict.first->time < verdicts_.at(*first).first->time)) first = topic;
  }
  return first;
}

std::uint64_t OutputComparison::compared() const {
  std::uint64_t sum = 0;
  for (const auto& [topic, verdict] : verdicts_) sum += verdict.equal + verdict.differing;
  return sum;
}

}  // namespace bw::replay
