#include "runtime/cli/bag_words.hpp"

#include <algorithm>
#include <cstdint>
#include <iostream>

#include <fmt/format.h>

namespace bw::cli {
namespace {

using nlohmann::json;

std::uint64_t size_on_disk(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return std::filesystem::file_size(path);
  std::uint64_t sum = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.is_regular_file()) sum += entry.file_size();
  }
  return sum;
}

}  // namespace

std::string in_words(const bag::BagFault& fault) {
  if (fault.file.empty()) return fault.what;
  return fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what);
}

json to_json(const bag::BagFault& fault) {
  return {{"file", fault.file.string()}, {"offset", fault.offset}, {"what", fault.what}};
}

json to_json(const std::vector<bag::BagFault>& faults) {
  json all = json::array();
  for (const bag::BagFault& fault : faults) all.push_back(to_json(fault));
  return all;
}

std::string rate_in_words(double hz) { return hz > 0.0 ? fmt::format("{:.2f} Hz", hz) : "-"; }

json describe(const bag::Bag& recording, const std::filesystem::path& path) {
  json head = {{"path", path.string()},
               {"storage", recording.storage()},
               {"profile", recording.profile()},
               {"size_bytes", size_on_disk(path)},
               {"start_s", recording.start().to_seconds()},
               {"duration_s", (recording.end() - recording.start()).to_seconds()},
               {"messages", recording.message_count()},
               {"topics", json::array()},
               {"attachments", json::array()},
               {"dropped", json::object()},
               {"lost", json::object()},
               {"faults", json::array()}};
  for (const auto& a : recording.attachments())
    head["attachments"].push_back({{"name", a.name}, {"bytes", a.size}});
  const auto metadata = recording.metadata();
  for (const char* record : {"dropped", "lost"}) {
    if (const auto counts = metadata.find(record); counts != metadata.end()) {
      for (const auto& [topic, count] : counts->second) head[record][topic] = count;
    }
  }
  return head;
}

void print_head(const json& description) {
  const auto text = [&](const char* key) { return description[key].get<std::string>(); };
  const std::string profile = text("profile") == "ros2" ? "" : " of profile \"" + text("profile") + "\"";
  std::cout << fmt::format("{}: {} file{}, {:.2f} MB, {} messages of {} topics, {:.3f} s from {:.3f}\n",
                           text("path"), text("storage"), profile,
                           description["size_bytes"].get<double>() * 1e-6,
                           description["messages"].get<std::uint64_t>(), description["topics"].size(),
                           description["duration_s"].get<double>(), description["start_s"].get<double>());
}

void print_table(const std::vector<std::vector<std::string>>& rows, std::string_view alignment) {
  std::vector<std::size_t> width(alignment.size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += i > 0 ? "  " : "";
      line += alignment[i] == '>' ? fmt::format("{:>{}}", row[i], width[i])
                                  : fmt::format("{:<{}}", row[i], width[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << "\n";
  }
}

}  // namespace bw::cli
