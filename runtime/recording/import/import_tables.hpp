// Tables into the messages of a bag, by a columns file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/import/columns_file.hpp"
#include "runtime/recording/import/row_importer.hpp"

namespace bw::imports {

struct ImportedMessage {
  std::size_t topic = 0;  ///< in ImportedLog::topics
  Time stamp;
  bag::Bytes data;  ///< CDR
};

/// What became of the rows of one table on one topic.
struct TopicImport {
  std::string table;
  std::string topic;
  AtStamp on_duplicate = AtStamp::refuse;
  AtStamp on_falling = AtStamp::refuse;
  RowCounts counts;
};

struct ImportedLog {
  std::vector<bag::BagTopic> topics;
  /// By stamp; those of one stamp in the order of the columns file, then of the rows.
  std::vector<ImportedMessage> messages;
  std::map<std::string, std::map<std::string, std::string>> metadata;  ///< bag::kLogRecord
  std::vector<TopicImport> report;
};

/// Each table is read by the entry whose `file` is its name. A folder stands for the files in it that entries
/// name.
/// Throws ConfigError for what is wrong with the columns file, TableError for what is wrong in a table, and
/// std::runtime_error naming a file that is not there, that no entry names, or that an entry misses.
ImportedLog import_tables(const ColumnsFile& columns, const std::vector<std::filesystem::path>& tables);

}  // namespace bw::imports
