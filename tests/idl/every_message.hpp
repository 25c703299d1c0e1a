// Every type of the build.
#pragma once

#include <memory>
#include <vector>

#include "all_messages.hpp"
#include "tests/idl/any_message.hpp"

namespace bw::test {

/// One of each, in every layout.
inline std::vector<std::unique_ptr<AnyMessage>> every_message() {
  std::vector<std::unique_ptr<AnyMessage>> messages;
  for_each_message([&]<class M>() { messages.push_back(std::make_unique<MessageOf<M>>()); });
  return messages;
}

}  // namespace bw::test
