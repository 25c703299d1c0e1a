// A bag beside another: its recorded inputs, with the outputs that components write now. The truth from then
// on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/bag_writer.hpp"

namespace bw::replay {

/// drive.mcap -> drive.replayed.mcap, drive/ -> drive.replayed/
[[nodiscard]] std::filesystem::path beside(const std::filesystem::path& recording);

class UpdatedBag {
 public:
  /// Throws as BagWriter does. `recording` must outlive this.
  UpdatedBag(const bag::Bag& recording, const std::filesystem::path& path);

  /// By the topic of the recording.
  void write(std::size_t topic, Time log_time, Time publish_time, bag::BytesView cdr);
  /// Attachments and metadata of the recording, with this build and `parameters` (replayed_parameters.yaml),
  /// and the end.
  void finish(const std::string& parameters);

 private:
  const bag::Bag& recording_;
  bag::BagWriter writer_;
};

}  // namespace bw::replay
