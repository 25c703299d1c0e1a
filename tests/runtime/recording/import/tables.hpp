// Tables and columns files in a folder of the test's own.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "runtime/recording/import/import_tables.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw::imports {

class Tables {
 public:
  Tables()
      : folder_(std::filesystem::temp_directory_path() /
                ("bandwagon_import_" + std::to_string(getpid()) + "_" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Tables() { std::filesystem::remove_all(folder_); }
  Tables(const Tables&) = delete;
  Tables& operator=(const Tables&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Writes the columns file and imports what the folder has.
  ImportedLog import(const std::string& columns) const {
    return import_tables(read_columns_file(write("columns.yaml", columns)), {folder_});
  }

  /// What the import says when it refuses; empty when it does not.
  std::string refusal(const std::string& columns) const {
    try {
      import(columns);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path folder_;
};

/// The messages of one topic, decoded by the class of their type.
template <class Message>
std::vector<Message> messages_of(const ImportedLog& log, const std::string& topic) {
  std::vector<Message> list;
  for (const ImportedMessage& m : log.messages) {
    if (log.topics[m.topic].name != topic) continue;
    std::string reason;
    EXPECT_TRUE(deserialize(m.data, list.emplace_back(), &reason)) << reason;
  }
  return list;
}

}  // namespace bw::imports
