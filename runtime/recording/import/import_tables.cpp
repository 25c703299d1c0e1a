#include "runtime/recording/import/import_tables.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fnmatch.h>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/bag/log_record.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::imports {
namespace {

using Paths = std::vector<std::filesystem::path>;

bool is_named(const TableRule& rule, const std::filesystem::path& table) {
  return fnmatch(rule.file.c_str(), table.filename().c_str(), 0) == 0;
}

/// The tables themselves: a folder is replaced by those of its files that rules name, sorted by name.
Paths files_of(const ColumnsFile& columns, const Paths& tables) {
  Paths files;
  for (const auto& table : tables) {
    if (!std::filesystem::is_directory(table)) {
      files.push_back(table);
      continue;
    }
    Paths inside;
    for (const auto& entry : std::filesystem::directory_iterator(table)) {
      const bool wanted = std::ranges::any_of(
          columns.tables, [&](const TableRule& rule) { return is_named(rule, entry.path()); });
      if (wanted && entry.is_regular_file()) inside.push_back(entry.path());
    }
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// Of "nav_msgs/msg/Odometry", or "nav_msgs/Odometry" as ROS 1 wrote it.
const TypeDescription& type_of(const MessageRule& rule) {
  std::string name = rule.type;
  if (const std::size_t slash = name.find('/'); slash != std::string::npos && slash == name.rfind('/'))
    name.replace(slash, 1, "/msg/");
  if (const TypeDescription* type = find_type(name); type != nullptr && type->ros_name == name) return *type;
  std::vector<std::string_view> known;
  for (const TypeDescription* type : all_types()) known.push_back(type->ros_name);
  const auto near = nearest_of(name, known);
  throw ConfigError(Violation{rule.where, rule.key + ".type", rule.type,
                              near ? fmt::format("unknown type; did you mean '{}'?", *near)
                                   : "unknown type; a type is written as nav_msgs/msg/Odometry"});
}

/// The index of the topic in the list, which grows by it.
std::size_t topic_of(const MessageRule& rule, const TypeDescription& type,
                     std::vector<bag::BagTopic>& topics) {
  const auto found = std::ranges::find(topics, rule.topic, &bag::BagTopic::name);
  if (found != topics.end()) {
    if (found->type != type.ros_name) {
      throw ConfigError(Violation{rule.where, rule.key + ".type", rule.type,
                                  fmt::format("{} is {} in an entry before", rule.topic, found->type)});
    }
    return static_cast<std::size_t>(found - topics.begin());
  }
  topics.push_back({.name = rule.topic,
                    .type = std::string(type.ros_name),
                    .offered_qos_profiles =
                        bag::to_qos_text({rule.topic == "/tf_static" ? Qos::latched() : Qos::standard()}),
                    .type_hash = std::string(type.type_hash),
                    .schema_encoding = "ros2msg",
                    .schema_text = bag::schema_text(type)});
  return topics.size() - 1;
}

ColumnLayout layout_of(const MessageRule& rule, const TableReader& table, const Row& first) {
  if (!rule.columns.empty()) return ColumnLayout::of_list(rule.columns);
  if (table.header().cells.empty()) return ColumnLayout::of_width(first.cells.size());
  try {
    return ColumnLayout::of_header(table.header().cells);
  } catch (const std::invalid_argument& error) {
    throw TableError(table.name(), table.header().line, error.what());
  }
}

/// Reads one table.
class TableImport {
 public:
  TableImport(const TableRule& rule, const std::filesystem::path& file, ImportedLog& log)
      : rule_(rule), reader_(file, rule.format), log_(log) {
    for (const MessageRule& message : rule.messages)
      topics_.push_back(topic_of(message, type_of(message), log.topics));
    importers_.resize(rule.messages.size());
    if (!rule.format.header) return;
    for (std::size_t i = 0; i < importers_.size(); ++i) start(i, reader_.header());
  }

  void run() {
    for (Row row; reader_.next(row);) add(row);
    for (std::size_t i = 0; i < importers_.size(); ++i) {
      const MessageRule& message = rule_.messages[i];
      log_.report.push_back({.table = reader_.name(),
                             .topic = message.topic,
                             .on_duplicate = message.stamp.on_duplicate,
                             .on_falling = message.stamp.on_falling,
                             .counts = importers_[i] ? importers_[i]->counts() : RowCounts{}});
    }
  }

 private:
  void start(std::size_t i, const Row& row) {
    const MessageRule& message = rule_.messages[i];
    importers_[i].emplace(message, type_of(message), layout_of(message, reader_, row), reader_.name());
  }

  void add(const Row& row) {
    bool chosen = false;
    for (std::size_t i = 0; i < importers_.size(); ++i) {
      const std::string& word = rule_.messages[i].line;
      if (!word.empty() && (row.cells.empty() || row.cells.front() != word)) continue;
      chosen = true;
      if (rule_.messages[i].once && importers_[i] && importers_[i]->counts().messages > 0) continue;
      if (!importers_[i]) start(i, row);
      const std::optional<Time> stamp = importers_[i]->read(row);
      if (!stamp) continue;
      ImportedMessage& message = log_.messages.emplace_back();
      message.topic = topics_[i];
      message.stamp = *stamp;
      importers_[i]->write(message.data);
      ++log_.topics[topics_[i]].message_count;
    }
    if (chosen || rule_.other_lines) return;
    throw TableError(reader_.name(), row.line, 1, "", row.cells.empty() ? "" : row.cells.front(),
                     "no message is made of lines that begin so; other_lines: ignore steps over them");
  }

  const TableRule& rule_;
  TableReader reader_;
  ImportedLog& log_;
  std::vector<std::size_t> topics_;  ///< by message of the rule
  std::vector<std::optional<RowImporter>> importers_;
};

std::map<std::string, std::string> log_record(const ColumnsFile& columns, const Paths& files) {
  std::map<std::string, std::string> record = {{"name", columns.log.name},
                                               {"columns", columns.path.filename()}};
  if (!columns.log.source.empty()) record["source"] = columns.log.source;
  if (!columns.log.licence.empty()) record["licence"] = columns.log.licence;
  if (columns.log.start) record["start"] = short_text(*columns.log.start);
  for (const auto& [name, value] : columns.log.parameters) record[name] = short_text(value);
  std::string& tables = record["tables"];
  for (const auto& file : files) tables += (tables.empty() ? "" : ", ") + file.filename().string();
  return record;
}

}  // namespace

ImportedLog import_tables(const ColumnsFile& columns, const std::vector<std::filesystem::path>& tables) {
  const Paths files = files_of(columns, tables);
  for (const auto& file : files) {
    const auto is_for_it = [&file](const TableRule& rule) { return is_named(rule, file); };
    if (std::ranges::none_of(columns.tables, is_for_it))
      throw std::runtime_error(file.string() + ": no table of " + columns.path.string() + " has this name");
  }
  ImportedLog log;
  for (const TableRule& rule : columns.tables) {
    bool found = false;
    for (const auto& file : files) {
      if (!is_named(rule, file)) continue;
      found = true;
      TableImport(rule, file, log).run();
    }
    if (!found && !rule.optional)
      throw ConfigError(
          Violation{rule.where, rule.key + ".file", rule.file, "no table of this name is given"});
  }
  std::ranges::stable_sort(log.messages, {}, &ImportedMessage::stamp);
  log.metadata[bag::kLogRecord] = log_record(columns, files);
  return log;
}

}  // namespace bw::imports
