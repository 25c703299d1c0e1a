#include "runtime/recording/import/columns_file.hpp"

#include <stdexcept>

#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/recording/import/column_layout.hpp"
#include "runtime/recording/import/stamp_text.hpp"
#include "runtime/recording/import/value_rule.hpp"

namespace bw::imports {
namespace {

using Violations = std::vector<Violation>;

/// A section that may be missing.
const ConfigNode& section(ParameterReader& reader, std::string_view name, const ConfigNode& none) {
  const ConfigNode* node = reader.find(name);
  if (node == nullptr || node->is_null()) return none;
  if (!node->is_map()) reader.refuse(*node, name, "must be a section of keys");
  return *node;
}

void read_log(const ConfigNode& node, LogDescription& log, Violations& violations) {
  ParameterReader reader(node, "log", violations);
  reader("name", log.name);
  reader("source", log.source);
  reader("licence", log.licence);
  if (const ConfigNode* start = reader.find("start")) {
    double seconds = 0.0;
    read_value(*start, "log.start", {}, seconds, violations);
    log.start = seconds;
  }
  const ConfigNode none;
  for (const ConfigEntry& entry : section(reader, "parameters", none).map)
    read_value(entry.value, "log.parameters." + entry.key, {}, log.parameters[entry.key], violations);
  reader.refuse_unknown_keys();
}

void read_stamp(const ConfigNode& node, const std::string& key, StampRule& stamp, Violations& violations) {
  stamp.where = node.where;
  stamp.key = key;
  ParameterReader reader(node, key, violations);
  const auto text = [&reader](std::string_view name, std::string& value) {
    const ConfigNode* found = reader.find(name);
    if (found == nullptr) return;
    if (!found->is_scalar()) reader.refuse(*found, name, "must be one value");
    value = found->scalar;
  };
  text("column", stamp.column);
  text("unit", stamp.unit);
  text("nanoseconds", stamp.nanoseconds);
  text("offset", stamp.offset);
  reader("on_duplicate", stamp.on_duplicate);
  reader("on_falling", stamp.on_falling);
  reader.refuse_unknown_keys();
  const auto unit = unit_of(stamp.unit);
  if (!unit || unit->powers != kTime)
    violations.push_back(
        {node.where, key + ".unit", stamp.unit, "must be a unit of time: s, ms, us, ns, min, h"});
  if (!stamp_of_text(stamp.offset, "s"))
    violations.push_back({node.where, key + ".offset", stamp.offset, "must be a number of seconds"});
}

void read_values(const ConfigNode& message, const std::string& key, MessageRule& rule,
                 Violations& violations) {
  for (const bool constant : {false, true}) {
    const std::string name = constant ? "constants" : "fields";
    const ConfigNode* values = message.find(name);
    if (values == nullptr || values->is_null()) continue;
    if (!values->is_map()) {
      violations.push_back({values->where, key + "." + name, values->text(), "must be a section of fields"});
      continue;
    }
    for (const ConfigEntry& entry : values->map)
      rule.values.push_back(read_value_rule(entry, key + "." + name, constant, violations));
  }
}

/// `table`: what its messages have in common.
MessageRule read_message(const ConfigNode& node, const std::string& key, const MessageRule& table,
                         Violations& violations) {
  MessageRule rule = table;
  rule.where = node.where;
  rule.key = key;
  ParameterReader reader(node, key, violations);
  reader("topic", rule.topic);
  reader("type", rule.type);
  reader("line", rule.line);
  reader("once", rule.once);
  reader("columns", rule.columns);
  if (const ConfigNode* columns = node.find("columns")) rule.columns_where = columns->where;
  if (const ConfigNode* stamp = reader.find("stamp"))
    read_stamp(*stamp, key + ".stamp", rule.stamp, violations);
  reader.find("fields");
  reader.find("constants");
  reader.refuse_unknown_keys();
  read_values(node, key, rule, violations);
  if (!rule.topic.starts_with('/'))
    violations.push_back(
        {node.where, key + ".topic", rule.topic, "must be the topic's full name, with a / before it"});
  if (rule.stamp.column.empty())
    violations.push_back({node.where, key + ".stamp", "", "column must name the column of the stamp"});
  try {
    static_cast<void>(ColumnLayout::of_list(rule.columns));
  } catch (const std::invalid_argument& error) {
    violations.push_back({rule.columns_where, key + ".columns", "", error.what()});
  }
  return rule;
}

TableRule read_table(const ConfigNode& node, const std::string& key, Violations& violations) {
  TableRule table{.where = node.where, .key = key};
  ParameterReader reader(node, key, violations);
  MessageRule common;
  reader("file", table.file);
  reader("optional", table.optional);
  reader("separator", table.format.separator);
  reader("header", table.format.header);
  reader("comment", table.format.comment);
  std::string others = "refuse";
  reader("other_lines", others, {.choices = {"refuse", "ignore"}});
  table.other_lines = others == "ignore";
  reader("columns", common.columns);
  if (const ConfigNode* columns = node.find("columns")) common.columns_where = columns->where;
  if (const ConfigNode* stamp = reader.find("stamp"))
    read_stamp(*stamp, key + ".stamp", common.stamp, violations);
  const ConfigNode* messages = reader.find("messages");
  reader.refuse_unknown_keys();
  if (table.file.empty()) violations.push_back({node.where, key + ".file", "", "must name the table"});
  if (table.format.header && !common.columns.empty())
    violations.push_back(
        {common.columns_where, key + ".columns", "", "the header names the columns already"});
  if (messages == nullptr || !messages->is_sequence() || messages->sequence.empty()) {
    violations.push_back({node.where, key + ".messages", "", "must be a list of messages"});
    return table;
  }
  for (const ConfigNode& message : messages->sequence) {
    const std::string message_key = key + ".messages." + std::to_string(table.messages.size());
    table.messages.push_back(read_message(message, message_key, common, violations));
    const MessageRule& read = table.messages.back();
    if (table.format.header && (!read.columns.empty() || !read.line.empty()))
      violations.push_back(
          {read.where, message_key, "", "a table with a header has neither line nor columns"});
  }
  return table;
}

}  // namespace

ColumnsFile read_columns_file(const std::filesystem::path& file) {
  const ConfigNode root = load_yaml(file);
  ColumnsFile columns{.path = file};
  Violations violations;
  ParameterReader reader(root, "", violations);
  const ConfigNode none;
  read_log(section(reader, "log", none), columns.log, violations);
  if (columns.log.name.empty()) columns.log.name = file.stem().string();
  const ConfigNode* tables = reader.find("tables");
  reader.refuse_unknown_keys();
  if (tables == nullptr || !tables->is_sequence() || tables->sequence.empty()) {
    violations.push_back({root.where, "tables", "", "must be a list of tables"});
  } else {
    for (const ConfigNode& table : tables->sequence) {
      columns.tables.push_back(
          read_table(table, "tables." + std::to_string(columns.tables.size()), violations));
    }
  }
  throw_if_any(std::move(violations));
  return columns;
}

}  // namespace bw::imports
