#include "components/robot_base/eddie/dialogue.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bw::eddie {
namespace {

constexpr Duration kQuiet = Duration::milliseconds(30);
constexpr std::size_t kLongestLine = 254;  ///< the board's own buffer

}  // namespace

void Dialogue::begin(Time now, Duration quiet) {
  asked_.reset();
  throw_away();
  quiet_until_ = now + quiet;
}

void Dialogue::throw_away() {
  counts_.bytes_thrown_away += line_.size();
  line_.clear();
  is_broken_ = false;
}

/// True when it ends a line. A byte that is no text breaks its line: without it, it might look like another
/// one.
bool Dialogue::take_byte(std::uint8_t byte) {
  if (byte == '\r') return true;
  if (byte == '\n') return false;
  const bool is_text = byte == '\t' || (byte >= 32 && byte <= 126);
  if (is_text && !is_broken_ && line_.size() < kLongestLine) {
    line_ += static_cast<char>(byte);
    return false;
  }
  is_broken_ = true;
  ++counts_.bytes_thrown_away;
  return false;
}

std::optional<Reply> Dialogue::take(Time now, std::span<const std::uint8_t> bytes) {
  std::optional<Reply> reply;
  const bool is_listening = !asked_ && now < quiet_until_;
  if (is_listening) {
    counts_.bytes_thrown_away += bytes.size();
    if (!bytes.empty()) quiet_until_ = std::max(quiet_until_, now + kQuiet);
    return std::nullopt;
  }
  for (const std::uint8_t byte : bytes) {
    if (!take_byte(byte)) continue;
    const bool was_broken = std::exchange(is_broken_, false);
    std::string line = std::exchange(line_, {});
    if (was_broken || !asked_) {
      was_broken ? counts_.bytes_thrown_away += line.size() : ++counts_.unexpected_lines;
      if (!asked_) quiet_until_ = now + kQuiet;
      continue;
    }
    reply = Reply{asked_->request, false, std::move(line), asked_->at, now};
    asked_.reset();
    ++counts_.replies;
  }
  if (asked_ && asked_->at > now) asked_->at = now;
  if (asked_ && now - asked_->at >= timeout_) {
    reply = Reply{asked_->request, true, {}, asked_->at, now};
    ++counts_.timeouts;
    begin(now, kQuiet);
  }
  return reply;
}

void Dialogue::refuse(Time now) { begin(now, kQuiet); }

bool Dialogue::ask(Time now, Request request, std::string_view text, ByteLink& link) {
  throw_away();
  const auto* data = reinterpret_cast<const std::uint8_t*>(text.data());
  if (!link.write({data, text.size()})) return false;
  asked_ = Asked{request, now};
  return true;
}

}  // namespace bw::eddie
