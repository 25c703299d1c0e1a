// What a bag cannot be without, whichever of its files go: attachments, metadata, and the latest messages of
// latched topics, such as maps and fixed transforms. When the file that holds them is deleted they are
// written again.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/graph/qos.hpp"
#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

/// Messages that a late reader of the topic is owed; 0: none. What a lifespan ends is not owed.
[[nodiscard]] std::size_t latched_depth(const std::vector<Qos>& offered);

class Carried {
 public:
  struct Attachment {
    std::string name;
    std::string media_type;
    std::string content;
    Time time;
  };
  struct Metadata {
    std::string name;
    std::map<std::string, std::string> entries;
  };
  struct Message {
    std::size_t topic = 0;
    Time log_time;
    Time publish_time;
    Bytes data;
  };
  struct Parts {
    std::vector<Attachment> attachments;
    std::vector<Metadata> metadata;
    std::vector<Message> messages;
  };

  // `file`: a number that rises from file to file.
  void add(std::size_t file, Attachment attachment) { attachments_.push_back({file, std::move(attachment)}); }
  void add(std::size_t file, Metadata metadata) { metadata_.push_back({file, std::move(metadata)}); }
  /// Of a latched topic: the oldest beyond `depth` is let go.
  void add(std::size_t file, Message message, std::size_t depth);

  /// What lies in files up to `file`, which are gone. It is not carried any more until it is added again.
  [[nodiscard]] Parts take(std::size_t file);

 private:
  template <class T>
  struct In {
    std::size_t file = 0;
    T part;
  };
  std::vector<In<Attachment>> attachments_;
  std::vector<In<Metadata>> metadata_;
  std::map<std::size_t, std::deque<In<Message>>> messages_;  ///< by topic
};

}  // namespace bw::bag
