#include <iostream>

#include <fmt/format.h>

#include "runtime/cli/bag_verbs.hpp"
#include "runtime/cli/bag_words.hpp"
#include "runtime/recording/bag/bag_report.hpp"

namespace bw::cli {
namespace {

using nlohmann::json;

json to_json(const bag::TopicReport& topic, Time start) {
  const bool has_gap = topic.longest_gap > Duration{};
  return {{"name", topic.name},
          {"type", topic.type},
          {"writer", topic.writer},
          {"not_decoded", topic.difference},
          {"count", topic.count},
          {"bytes", topic.bytes},
          {"rate_hz", topic.rate()},
          {"longest_gap_s", topic.longest_gap.to_seconds()},
          {"longest_gap_at_s", has_gap ? (topic.longest_gap_at - start).to_seconds() : 0.0},
          {"falling_stamps", topic.falling},
          {"malformed", topic.malformed}};
}

void print_topics(const bag::BagReport& report, Time start) {
  std::vector<std::vector<std::string>> rows = {
      {"topic", "count", "rate", "longest gap", "at", "type", "written by"}};
  for (const bag::TopicReport& topic : report.topics) {
    const bool has_gap = topic.longest_gap > Duration{};
    rows.push_back({topic.name, std::to_string(topic.count), rate_in_words(topic.rate()),
                    has_gap ? fmt::format("{:.3f} s", topic.longest_gap.to_seconds()) : "-",
                    has_gap ? fmt::format("{:.2f} s", (topic.longest_gap_at - start).to_seconds()) : "-",
                    topic.type, topic.writer});
  }
  print_table(rows, "<>>>><<");
}

void print_problems(const bag::BagReport& report, Time start) {
  const auto after = [&](Time t) { return (t - start).to_seconds(); };
  for (const bag::BagFault& fault : report.faults) std::cout << "damage: " << in_words(fault) << "\n";
  for (const bag::TopicReport& topic : report.topics) {
    if (topic.falling > 0)
      std::cout << fmt::format("order: {}: {} stamps fall, the first at {:.3f} s\n", topic.name,
                               topic.falling, after(topic.first_falling));
    if (topic.malformed > 0)
      std::cout << fmt::format("content: {}: {} messages are no {}: {}\n", topic.name, topic.malformed,
                               topic.type, topic.first_malformed);
    if (!topic.difference.empty())
      std::cout << fmt::format("not decoded: {}: {}\n", topic.name, topic.difference);
  }
  for (const bag::ClockJump& jump : report.clock_jumps)
    std::cout << fmt::format("clock: at {:.3f} s the stamps move by {:.3f} s against the recorder's clock\n",
                             after(jump.at), -jump.by.to_seconds());
}

}  // namespace

int bag_check(const std::filesystem::path& path, bool as_json) {
  const auto recording = bag::open_bag(path);
  const bag::BagReport report = examine(*recording);
  const Time start = recording->start();
  json description = describe(*recording, path);
  for (const bag::TopicReport& topic : report.topics) description["topics"].push_back(to_json(topic, start));
  description["faults"] = to_json(report.faults);
  description["clock_jumps"] = json::array();
  for (const bag::ClockJump& jump : report.clock_jumps)
    description["clock_jumps"].push_back(
        {{"at_s", (jump.at - start).to_seconds()}, {"by_s", jump.by.to_seconds()}});
  description["sound"] = report.is_sound();
  if (as_json) {
    std::cout << description.dump(2) << "\n";
    return report.is_sound() ? 0 : 1;
  }
  print_head(description);
  print_topics(report, start);
  print_problems(report, start);
  if (report.is_sound()) std::cout << "sound: " << recording->message_count() << " messages\n";
  return report.is_sound() ? 0 : 1;
}

}  // namespace bw::cli
