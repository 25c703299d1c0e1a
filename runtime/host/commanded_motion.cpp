#include "runtime/host/commanded_motion.hpp"

#include <algorithm>
#include <variant>

#include "runtime/wire/leaves.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

bool is_not_zero(const Leaf& leaf) {
  const double* number = std::get_if<double>(&leaf.value);
  return number != nullptr && !(*number == 0.0);  // NaN is not
}

bool moves(const TypeDescription* type, std::span<const std::uint8_t> cdr) {
  if (type == nullptr) return true;
  const std::vector<Leaf> leaves = leaves_of(*type, cdr);
  return leaves.empty() || std::ranges::any_of(leaves, is_not_zero);
}

}  // namespace

void CommandedMotion::see(const MessageType& type, std::span<const std::uint8_t> cdr, Duration now) {
  if (moves(description_of(type), cdr)) last_ns_ = now.nanoseconds;
}

const TypeDescription* CommandedMotion::description_of(const MessageType& type) {
  const std::lock_guard lock(mutex_);
  const auto [entry, is_new] = types_.try_emplace(type.type_hash, nullptr);
  if (is_new) entry->second = find_type(type.ros_name, type.type_hash);
  return entry->second;
}

}  // namespace bw
