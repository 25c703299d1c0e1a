#include "runtime/recording/bag/carried.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace bw::bag {
namespace {

/// Moves the parts up to `file` from the front: they are in the order of their files.
template <class Held, class T>
void take_up_to(std::size_t file, Held& held, std::vector<T>& out) {
  const auto end = std::ranges::find_if(held, [file](const auto& in) { return in.file > file; });
  std::transform(held.begin(), end, std::back_inserter(out), [](auto& in) { return std::move(in.part); });
  held.erase(held.begin(), end);
}

}  // namespace

std::size_t latched_depth(const std::vector<Qos>& offered) {
  std::size_t depth = 0;
  for (const Qos& qos : offered) {
    if (qos.durability == Durability::transient_local && !qos.lifespan)
      depth = std::max(depth, static_cast<std::size_t>(std::max(qos.depth, 1)));
  }
  return depth;
}

void Carried::add(std::size_t file, Message message, std::size_t depth) {
  auto& held = messages_[message.topic];
  held.push_back({file, std::move(message)});
  if (held.size() > depth) held.pop_front();
}

Carried::Parts Carried::take(std::size_t file) {
  Parts parts;
  take_up_to(file, attachments_, parts.attachments);
  take_up_to(file, metadata_, parts.metadata);
  for (auto& [topic, held] : messages_) take_up_to(file, held, parts.messages);
  return parts;
}

}  // namespace bw::bag
