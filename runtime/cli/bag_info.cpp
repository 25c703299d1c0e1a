#include <algorithm>
#include <cstdint>
#include <iostream>
#include <map>

#include <fmt/format.h>

#include "runtime/cli/bag_verbs.hpp"
#include "runtime/cli/bag_words.hpp"
#include "runtime/recording/bag/known_type.hpp"

namespace bw::cli {
namespace {

using nlohmann::json;

/// A topic of one type, whoever writes it.
struct TopicInfo {
  std::string name;
  std::string type;
  std::uint64_t count = 0;
  std::map<std::string, std::uint64_t> writers;  ///< messages by node, where the bag tells
  std::string not_decoded;  ///< why, for a type that has our name; empty: it is ours, or unknown
  bool is_known = false;
};

std::vector<TopicInfo> topics_of(const bag::Bag& recording) {
  std::vector<TopicInfo> all;
  for (const bag::BagTopic& topic : recording.topics()) {
    auto same = std::ranges::find_if(
        all, [&](const TopicInfo& t) { return t.name == topic.name && t.type == topic.type; });
    if (same == all.end()) same = all.insert(all.end(), {.name = topic.name, .type = topic.type});
    same->count += topic.message_count;
    if (!topic.writer.empty()) same->writers[topic.writer] += topic.message_count;
    const bag::KnownType known = bag::known_type(topic);
    same->not_decoded = known.why;
    same->is_known = known.type != nullptr;
  }
  return all;
}

/// Messages per second of the whole bag; 0 for a single message.
double rate(std::uint64_t count, double duration_s) {
  return count < 2 || duration_s <= 0.0 ? 0.0 : static_cast<double>(count) / duration_s;
}

std::string writers_in_words(const std::map<std::string, std::uint64_t>& writers) {
  std::string text;
  for (const auto& [node, count] : writers) {
    text += (text.empty() ? "" : ", ") + node;
    if (writers.size() > 1) text += fmt::format(" {}", count);
  }
  return text;
}

void print_tail(const json& head) {
  for (const auto& a : head["attachments"])
    std::cout << fmt::format("attachment {} ({} bytes)\n", a["name"].get<std::string>(),
                             a["bytes"].get<std::uint64_t>());
  for (const auto& [topic, count] : head["dropped"].items())
    std::cout << fmt::format("dropped while recording: {} of {}\n", count.get<std::string>(), topic);
  for (const auto& [topic, count] : head["lost"].items())
    std::cout << fmt::format("lost on the wire while recording: {} of {}\n", count.get<std::string>(), topic);
}

}  // namespace

int bag_info(const std::filesystem::path& path, bool as_json) {
  const auto recording = bag::open_bag(path);
  json head = describe(*recording, path);
  const double duration_s = head["duration_s"];
  std::vector<std::vector<std::string>> rows = {{"topic", "count", "rate", "type", "written by"}};
  for (const TopicInfo& topic : topics_of(*recording)) {
    const double hz = rate(topic.count, duration_s);
    json entry = {{"name", topic.name},
                  {"type", topic.type},
                  {"count", topic.count},
                  {"rate_hz", hz},
                  {"writers", topic.writers},
                  {"known_type", topic.is_known},
                  {"not_decoded", topic.not_decoded}};
    head["topics"].push_back(std::move(entry));
    const std::string unknown = topic.is_known ? "" : " (not decoded)";
    rows.push_back({topic.name, std::to_string(topic.count), rate_in_words(hz), topic.type + unknown,
                    writers_in_words(topic.writers)});
  }
  head["faults"] = to_json(recording->faults());
  if (as_json) {
    std::cout << head.dump(2) << "\n";
    return 0;
  }
  print_head(head);
  print_table(rows, "<>><<");
  print_tail(head);
  for (const auto& topic : head["topics"]) {
    if (const std::string why = topic["not_decoded"]; !why.empty())
      std::cout << topic["name"].get<std::string>() << " is not decoded: " << why << "\n";
  }
  for (const bag::BagFault& fault : recording->faults()) std::cout << "damage: " << in_words(fault) << "\n";
  return 0;
}

}  // namespace bw::cli
