// A recorded bag, whatever its storage: an MCAP file, a rosbag2 folder of MCAP or SQLite files, or a single
// SQLite file.
//
//   const auto bag = bag::open_bag("run/demo/drive.mcap");
//   auto messages = bag->messages({});
//   for (BagMessage m; messages->next(m) == Step::message;) ...
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

struct BagTopic {
  std::string name;  ///< /odom
  std::string type;  ///< nav_msgs/msg/Odometry
  std::string
      writer;  ///< node that wrote it, where the bag tells: a topic of several writers stands there once for each
  std::string serialization_format = "cdr";
  std::string offered_qos_profiles;  ///< YAML text (qos_text.hpp)
  std::string type_hash;             ///< RIHS01_..., empty when the bag does not know it
  std::string schema_encoding;       ///< ros2msg, ros2idl, unknown, or empty
  std::string schema_text;
  std::uint64_t message_count = 0;
};

/// Of one name, type and writer.
[[nodiscard]] inline bool is_same_topic(const BagTopic& a, const BagTopic& b) {
  return a.name == b.name && a.type == b.type && a.writer == b.writer;
}

/// `data` is valid until the next message is read.
struct BagMessage {
  std::size_t topic = 0;  ///< in Bag::topics()
  Time log_time;          ///< component clock of the recorder
  Time publish_time;      ///< the writer's stamp, or log_time
  BytesView data;         ///< CDR with its encapsulation
};

/// Something in a bag that is not as it should be.
struct BagFault {
  std::filesystem::path file;
  std::uint64_t offset = 0;  ///< [bytes]
  std::string what;
};

struct BagSelection {
  Time start{std::numeric_limits<std::int64_t>::min()};        ///< inclusive
  Time end{std::numeric_limits<std::int64_t>::max()};          ///< exclusive, its greatest value apart
  std::optional<std::set<std::string>> topics = std::nullopt;  ///< nothing: all
};

enum class Step { message, end, damaged };

/// Messages by log time; those of one time in the order they were written.
class BagMessages {
 public:
  virtual ~BagMessages() = default;
  /// `damaged`: fault() says what is lost; the next call goes on behind it.
  virtual Step next(BagMessage& message) = 0;
  [[nodiscard]] virtual BagFault fault() const = 0;
};

struct BagAttachment {
  std::string name;
  std::string media_type;
  std::uint64_t size = 0;      ///< [bytes]
  std::filesystem::path file;  ///< that holds it
  std::uint64_t offset = 0;    ///< in it [bytes]
};

class Bag {
 public:
  virtual ~Bag() = default;
  [[nodiscard]] virtual std::string storage() const = 0;  ///< mcap or sqlite3
  /// How messages are to be understood: `ros2`, or what another recorder wrote, which may be nothing.
  [[nodiscard]] virtual std::string profile() const = 0;
  [[nodiscard]] virtual const std::vector<BagTopic>& topics() const = 0;
  [[nodiscard]] virtual Time start() const = 0;  ///< log time of the first message
  [[nodiscard]] virtual Time end() const = 0;    ///< of the last one
  [[nodiscard]] virtual std::uint64_t message_count() const = 0;
  [[nodiscard]] virtual std::vector<BagAttachment> attachments() const = 0;
  [[nodiscard]] virtual std::optional<Bytes> attachment(const std::string& name) const = 0;
  /// Metadata records by name.
  [[nodiscard]] virtual std::map<std::string, std::map<std::string, std::string>> metadata() const = 0;
  /// What was found wrong when it was opened; a file that was not closed is one.
  [[nodiscard]] virtual const std::vector<BagFault>& faults() const = 0;
  /// What a look at every byte tells that reading the messages does not: other checksums. May take long.
  [[nodiscard]] virtual std::vector<BagFault> verify() const = 0;
  /// The bag must outlive what this returns.
  [[nodiscard]] virtual std::unique_ptr<BagMessages> messages(const BagSelection& selection) const = 0;
};

/// A file, or a folder with or without metadata.yaml. Throws std::runtime_error naming the path for what is
/// no bag.
[[nodiscard]] std::unique_ptr<Bag> open_bag(const std::filesystem::path& path);

/// Several as one, by log time; of one time those of the earlier bag first. At least one.
[[nodiscard]] std::unique_ptr<Bag> join_bags(std::vector<std::unique_ptr<Bag>> bags);

}  // namespace bw::bag
