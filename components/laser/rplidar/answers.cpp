#include "components/laser/rplidar/answers.hpp"

namespace bw::laser {

void AnswerReader::restart() {
  waiting_.clear();
  is_streaming_ = false;
}

const Received& AnswerReader::read(std::span<const std::uint8_t> bytes) {
  received_ = {};
  if (is_streaming_) {
    nodes_.read(bytes, received_.nodes);
    return received_;
  }
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  taken_ = 0;
  while (!is_streaming_ && take_one()) {
  }
  if (is_streaming_) nodes_.read(std::span(waiting_).subspan(taken_), received_.nodes);
  waiting_.erase(waiting_.begin(),
                 waiting_.begin() + static_cast<std::ptrdiff_t>(is_streaming_ ? waiting_.size() : taken_));
  return received_;
}

/// False when more bytes are needed.
bool AnswerReader::take_one() {
  const auto rest = std::span<const std::uint8_t>(waiting_).subspan(taken_);
  if (rest.size() < kHeaderSize) return false;
  const std::optional<AnswerType> type = read_header(rest);
  if (!type) {
    ++taken_;
    ++bytes_thrown_away_;
    return true;
  }
  const std::size_t size = kHeaderSize + (*type == AnswerType::nodes ? 0 : size_of(*type));
  if (rest.size() < size) return false;
  take_in(*type, rest.subspan(kHeaderSize));
  taken_ += size;
  return true;
}

void AnswerReader::take_in(AnswerType type, std::span<const std::uint8_t> data) {
  switch (type) {
    case AnswerType::info:
      received_.info = read_info(data.first<kInfoSize>());
      break;
    case AnswerType::health:
      received_.health = read_health(data.first<kHealthSize>());
      break;
    case AnswerType::sample_times:
      received_.sample_time = read_sample_time(data.first<kSampleTimesSize>());
      break;
    case AnswerType::nodes:
      received_.scan_begins = true;
      is_streaming_ = true;
      nodes_.begin();
      break;
  }
}

}  // namespace bw::laser
