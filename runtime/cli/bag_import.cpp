// bandwagon-lab bag import: a bag of tables.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/cli/verb.hpp"
#include "runtime/recording/bag/log_record.hpp"
#include "runtime/recording/import/imported_bag.hpp"

namespace bw::cli {
namespace {

struct ImportOptions {
  std::vector<std::filesystem::path> tables;
  std::filesystem::path columns;
  std::filesystem::path out;
  bool json = false;
};

std::string stamps_in_words(const char* what, std::uint64_t count, imports::AtStamp rule) {
  if (count == 0) return "";
  return fmt::format(", {} {} stamps {}", count, what, rule == imports::AtStamp::drop ? "dropped" : "kept");
}

void print(const imports::ImportedLog& log, const std::filesystem::path& out) {
  for (const imports::TopicImport& topic : log.report) {
    const imports::RowCounts& c = topic.counts;
    std::cout << fmt::format("{}: {}: {} rows, {} messages{}{}{}\n", topic.table, topic.topic, c.rows,
                             c.messages, stamps_in_words("equal", c.duplicate_stamps, topic.on_duplicate),
                             stamps_in_words("falling", c.falling_stamps, topic.on_falling),
                             c.skipped > 0 ? fmt::format(", {} rows with a gap skipped", c.skipped) : "");
  }
  std::cout << fmt::format("{}: {} messages of {} topics\n", out.string(), log.messages.size(),
                           log.topics.size());
}

nlohmann::json to_json(const imports::ImportedLog& log, const std::filesystem::path& out) {
  nlohmann::json json = {{"bag", out.string()},
                         {"log", log.metadata.at(bag::kLogRecord)},
                         {"messages", log.messages.size()},
                         {"tables", nlohmann::json::array()}};
  for (const imports::TopicImport& topic : log.report) {
    const imports::RowCounts& c = topic.counts;
    json["tables"].push_back({{"table", topic.table},
                              {"topic", topic.topic},
                              {"rows", c.rows},
                              {"messages", c.messages},
                              {"skipped", c.skipped},
                              {"duplicate_stamps", c.duplicate_stamps},
                              {"on_duplicate", text_of(topic.on_duplicate)},
                              {"falling_stamps", c.falling_stamps},
                              {"on_falling", text_of(topic.on_falling)}});
  }
  return json;
}

void run(const ImportOptions& options) {
  const imports::ColumnsFile columns = imports::read_columns_file(options.columns);
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(columns.log.name + ".mcap") : options.out;
  const imports::ImportedLog log = imports::import_tables(columns, options.tables);
  imports::write_bag(log, out);
  if (options.json) {
    std::cout << to_json(log, out).dump(2) << "\n";
  } else {
    print(log, out);
  }
}

void add_bag(Verb bag) {
  auto options = std::make_shared<ImportOptions>();
  Verb verb = bag.verb("import", "A bag of CSV or white-space tables (config/imports/README.md)");
  verb.option("TABLE", options->tables, "Tables, or the folder that they are in").required();
  verb.option("--columns", options->columns, "Which column is which field of which message").required();
  verb.option("--out", options->out, "New .mcap file, or a folder; else NAME.mcap by the log's name");
  verb.flag("--json", options->json, "What was imported, as JSON");
  verb.run([options] { run(*options); });
}

}  // namespace

BW_VERB(look, "bag", "Recorded bags, made of tables", add_bag)

}  // namespace bw::cli
