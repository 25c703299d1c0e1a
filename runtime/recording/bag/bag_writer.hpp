// Writes a recording: one MCAP file, or a folder of them with the metadata.yaml of rosbag2, split by size or
// time.
//
//   drive.mcap          one file
//   drive/              drive_0.mcap, drive_1.mcap, ..., metadata.yaml
//
// metadata.yaml comes with the end: without it, after a kill, a folder is all the files in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/bag_metadata.hpp"
#include "runtime/recording/bag/carried.hpp"
#include "runtime/recording/bag/mcap_writer.hpp"

namespace bw::bag {

struct BagWriterOptions {
  Compression compression = Compression::zstd;
  std::string profile = "ros2";  ///< of MCAP: what messages and schemas are to be understood as
  std::string ros_distro = default_ros_distro();
  std::uint64_t split_size = 0;  ///< a new file begins beyond this [bytes]; 0: never. Folders only
  Duration split_duration{};     ///< or after this time; 0: never. Folders only
  /// The oldest files go, so that all together stay below this [bytes]; 0: they stay. Attachments, metadata
  /// and latched messages in them are written again. Without a split_size files are split at a tenth of it.
  /// Folders only
  std::uint64_t max_size = 0;
  /// Makes the files; a test puts a disk that is full or slow in this place.
  std::function<std::unique_ptr<ByteSink>(const std::filesystem::path&)> create = create_file;
  /// Gets a file when its end is written.
  std::function<void(std::shared_ptr<ByteSink>)> sync = [](const auto& file) { file->sync(); };
};

class BagWriter {
 public:
  /// `path` ends in .mcap: one file; else a folder, which is made. Throws std::runtime_error or
  /// std::system_error naming the path: it exists already, somebody records there, or it cannot be written.
  /// Every later call may throw what the sinks throw; what was written before stays.
  BagWriter(std::filesystem::path path, BagWriterOptions options);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// Names the topic in write(). Its message_count is not looked at.
  std::size_t add_topic(const BagTopic& topic);
  void write(std::size_t topic, Time log_time, Time publish_time, BytesView data);
  /// In the file that is open now.
  void attach(const std::string& name, const std::string& media_type, std::string_view content, Time now);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& entries);
  /// What was written so far survives a kill of the program.
  void flush();
  /// What was flushed so far survives a power cut when this file is synced, by any thread.
  [[nodiscard]] const std::shared_ptr<ByteSink>& sink() const { return file_->sink(); }
  /// Writes summaries and metadata.yaml.
  void close();

  [[nodiscard]] std::uint64_t size() const;  ///< of all files [bytes]
  [[nodiscard]] std::uint64_t message_count() const { return metadata_.message_count; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void open_file();
  void close_file();
  void delete_oldest(Time now);
  void write_message(std::size_t topic, Time log_time, Time publish_time, BytesView data);
  void span_files();
  [[nodiscard]] std::filesystem::path file_path(std::size_t number) const;

  std::filesystem::path path_;
  BagWriterOptions options_;
  bool is_folder_;
  int lock_ = -1;
  std::vector<BagTopic> topics_;
  std::vector<std::size_t> listed_as_;  ///< by topic: its index in metadata_.topics, which knows no writers
  std::vector<std::size_t> latched_depths_;  ///< by topic
  std::map<std::pair<std::string, std::string>, std::uint16_t>
      schema_ids_;  ///< by type, and encoding with text
  std::vector<mcap::Schema> schemas_;
  std::vector<mcap::Channel> channels_;
  std::unique_ptr<mcap::Writer> file_;
  std::size_t next_number_ = 0;
  Time file_start_;
  bool file_has_messages_ = false;
  BagMetadata metadata_;
  /// A file that was closed and is still there.
  struct Closed {
    std::size_t number = 0;
    std::uint64_t size = 0;                         ///< [bytes]
    std::map<std::uint16_t, std::uint64_t> counts;  ///< messages by channel
  };
  std::vector<Closed> closed_;  ///< the oldest first, as in metadata_
  Carried carried_;             ///< with a max_size
};

}  // namespace bw::bag
