// bandwagon bag info|check|recover|convert|import: recorded bags, looked at, mended, and made of tables.
#include <iostream>
#include <memory>
#include <stdexcept>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/bag/bag_report.hpp"
#include "runtime/bag/bag_writer.hpp"
#include "runtime/bag/mcap_recover.hpp"
#include "runtime/cli/bag_import.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::cli {
namespace {

struct BagOptions {
  std::string path;
  std::string out;
  std::string compression = "zstd";
  bool json = false;
};

std::uint64_t size_on_disk(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return std::filesystem::file_size(path);
  std::uint64_t sum = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.is_regular_file()) sum += entry.file_size();
  }
  return sum;
}

std::string in_words(const bag::BagFault& fault) {
  return fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what);
}

nlohmann::json to_json(const bag::BagFault& fault) {
  return {{"file", fault.file.string()}, {"offset", fault.offset}, {"what", fault.what}};
}

nlohmann::json to_json(const bag::TopicReport& topic, Time start) {
  return {{"name", topic.name},
          {"type", topic.type},
          {"count", topic.count},
          {"bytes", topic.bytes},
          {"rate_hz", topic.rate()},
          {"longest_gap_s", topic.longest_gap.to_seconds()},
          {"longest_gap_at_s",
           topic.longest_gap > Duration{} ? (topic.longest_gap_at - start).to_seconds() : 0.0},
          {"falling_stamps", topic.falling},
          {"malformed", topic.malformed}};
}

nlohmann::json to_json(const bag::Bag& recording, const bag::BagReport& report, const std::string& path) {
  nlohmann::json json = {{"path", path},
                         {"storage", recording.storage()},
                         {"size_bytes", size_on_disk(path)},
                         {"start_s", recording.start().to_seconds()},
                         {"duration_s", (recording.end() - recording.start()).to_seconds()},
                         {"messages", recording.message_count()},
                         {"topics", nlohmann::json::array()},
                         {"attachments", nlohmann::json::array()},
                         {"dropped", nlohmann::json::object()},
                         {"lost", nlohmann::json::object()},
                         {"faults", nlohmann::json::array()},
                         {"clock_jumps", nlohmann::json::array()},
                         {"sound", report.is_sound()}};
  for (const auto& topic : report.topics) json["topics"].push_back(to_json(topic, recording.start()));
  for (const auto& a : recording.attachments())
    json["attachments"].push_back({{"name", a.name}, {"bytes", a.size}});
  for (const auto& fault : report.faults) json["faults"].push_back(to_json(fault));
  for (const auto& jump : report.clock_jumps) {
    json["clock_jumps"].push_back(
        {{"at_s", (jump.at - recording.start()).to_seconds()}, {"by_s", jump.by.to_seconds()}});
  }
  const auto metadata = recording.metadata();
  for (const char* record : {"dropped", "lost"}) {
    if (const auto counts = metadata.find(record); counts != metadata.end()) {
      for (const auto& [topic, count] : counts->second) json[record][topic] = count;
    }
  }
  return json;
}

void print_topics(const bag::BagReport& report, Time start) {
  std::size_t width = 5;
  for (const auto& topic : report.topics) width = std::max(width, topic.name.size());
  std::cout << fmt::format("{:{}}  {:>8} {:>9} {:>11}  type\n", "topic", width, "count", "rate",
                           "longest gap");
  for (const auto& topic : report.topics) {
    const std::string rate = topic.rate() > 0.0 ? fmt::format("{:.2f} Hz", topic.rate()) : "-";
    const std::string gap =
        topic.longest_gap > Duration{} ? fmt::format("{:.3f} s", topic.longest_gap.to_seconds()) : "-";
    const std::string at =
        topic.longest_gap > Duration{}
            ? fmt::format(" (gap at {:.2f} s)", (topic.longest_gap_at - start).to_seconds())
            : "";
    std::cout << fmt::format("{:{}}  {:>8} {:>9} {:>11}  {}{}\n", topic.name, width, topic.count, rate, gap,
                             topic.type, at);
  }
}

int info(const BagOptions& options) {
  const auto recording = bag::open_bag(options.path);
  const bag::BagReport report = examine(*recording);
  const nlohmann::json json = to_json(*recording, report, options.path);
  if (options.json) {
    std::cout << json.dump(2) << "\n";
    return 0;
  }
  std::cout << fmt::format("{}: {} file, {:.2f} MB, {} messages of {} topics, {:.3f} s from {:.3f}\n",
                           options.path, recording->storage(), json["size_bytes"].get<double>() * 1e-6,
                           recording->message_count(), recording->topics().size(),
                           json["duration_s"].get<double>(), json["start_s"].get<double>());
  print_topics(report, recording->start());
  for (const auto& a : recording->attachments())
    std::cout << fmt::format("attachment {} ({} bytes)\n", a.name, a.size);
  for (const auto& [topic, count] : json["dropped"].items()) {
    std::cout << fmt::format("dropped while recording: {} of {}\n", count.get<std::string>(), topic);
  }
  for (const auto& [topic, count] : json["lost"].items()) {
    std::cout << fmt::format("lost on the wire while recording: {} of {}\n", count.get<std::string>(), topic);
  }
  for (const auto& fault : report.faults) std::cout << in_words(fault) << "\n";
  return 0;
}

int check(const BagOptions& options) {
  const auto recording = bag::open_bag(options.path);
  const bag::BagReport report = examine(*recording);
  if (options.json) {
    std::cout << to_json(*recording, report, options.path).dump(2) << "\n";
    return report.is_sound() ? 0 : 1;
  }
  for (const auto& fault : report.faults) std::cout << "damage: " << in_words(fault) << "\n";
  const auto after = [&](Time t) { return (t - recording->start()).to_seconds(); };
  for (const auto& topic : report.topics) {
    if (topic.falling > 0) {
      std::cout << fmt::format("order: {}: {} stamps fall, the first at {:.3f} s\n", topic.name,
                               topic.falling, after(topic.first_falling));
    }
    if (topic.malformed > 0) {
      std::cout << fmt::format("content: {}: {} messages are no {}: {}\n", topic.name, topic.malformed,
                               topic.type, topic.first_malformed);
    }
  }
  for (const auto& jump : report.clock_jumps) {
    std::cout << fmt::format("clock: at {:.3f} s the stamps move by {:.3f} s against the recorder's clock\n",
                             after(jump.at), -jump.by.to_seconds());
  }
  if (report.is_sound()) std::cout << "sound: " << recording->message_count() << " messages\n";
  return report.is_sound() ? 0 : 1;
}

int recover(const BagOptions& options) {
  const bag::mcap::RecoveryReport report = bag::mcap::recover(options.path, options.out);
  if (options.json) {
    nlohmann::json json = {{"messages", report.messages},
                           {"lost_bytes", report.lost_bytes},
                           {"was_whole", report.was_whole},
                           {"faults", nlohmann::json::array()}};
    for (const auto& fault : report.faults)
      json["faults"].push_back({{"offset", fault.offset}, {"what", fault.what}});
    std::cout << json.dump(2) << "\n";
  } else {
    for (const auto& fault : report.faults)
      std::cout << fmt::format("byte {}: {}\n", fault.offset, fault.what);
    std::cout << fmt::format("{} messages saved, {} bytes lost: {}\n", report.messages, report.lost_bytes,
                             options.out);
  }
  return report.lost_bytes == 0 ? 0 : 1;
}

int convert(const BagOptions& options) {
  const auto from = bag::open_bag(options.path);
  const bag::Compression compression = options.compression == "none"
                                           ? bag::Compression::none
                                           : bag::compression_of(options.compression).value();
  bag::BagWriter to(options.out, {.compression = compression});
  for (const bag::BagTopic& topic : from->topics()) to.add_topic(topic);
  for (const bag::BagAttachment& a : from->attachments()) {
    const auto content = from->attachment(a.name);
    if (!content) throw std::runtime_error(options.path + ": the attachment " + a.name + " is damaged");
    to.attach(a.name, a.media_type, {reinterpret_cast<const char*>(content->data()), content->size()},
              from->start());
  }
  for (const auto& [name, entries] : from->metadata()) {
    if (name != "rosbag2") to.add_metadata(name, entries);
  }
  const auto messages = from->messages({});
  bag::BagMessage m;
  int status = 0;
  for (bag::Step step = messages->next(m); step != bag::Step::end; step = messages->next(m)) {
    if (step == bag::Step::damaged) {
      std::cerr << in_words(messages->fault()) << "\n";
      status = 1;
      continue;
    }
    to.write(m.topic, m.log_time, m.publish_time, m.data);
  }
  to.close();
  std::cout << fmt::format("{} messages: {}\n", to.message_count(), options.out);
  return status;
}

CLI::App* add_bag(CLI::App& app, int& status) {
  auto options = std::make_shared<BagOptions>();
  CLI::App* bag =
      app.add_subcommand("bag", "Recorded bags: MCAP files, and the folders and SQLite files of rosbag2")
          ->require_subcommand(1);
  const auto verb = [&](const char* name, const char* what, int (*action)(const BagOptions&)) {
    CLI::App* one = bag->add_subcommand(name, what);
    one->add_option("BAG", options->path, "File or folder")->required();
    one->callback([options, &status, action] { status = action(*options); });
    return one;
  };
  verb("info", "What is in it", info)->add_flag("--json", options->json, "As JSON");
  verb("check", "Whether it is sound: damage, order, content, clocks; exit status 1 if not", check)
      ->add_flag("--json", options->json, "As JSON");
  CLI::App* recover_verb = verb("recover", "Saves what can be saved of a damaged MCAP file", recover);
  recover_verb->add_option("OUT", options->out, "New .mcap file")->required();
  recover_verb->add_flag("--json", options->json, "As JSON");
  CLI::App* convert_verb = verb("convert", "Writes it again, as MCAP", convert);
  convert_verb->add_option("OUT", options->out, "New .mcap file, or a folder")->required();
  convert_verb->add_option("--compression", options->compression, "zstd, lz4 or none")
      ->check(CLI::IsMember({"zstd", "lz4", "none"}));
  add_bag_import(*bag);
  return bag;
}

}  // namespace

BW_VERB(look, "bag", add_bag)

}  // namespace bw::cli
