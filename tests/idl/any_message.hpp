// Every generated class behind one interface: what walks all of them is compiled once, not once for each.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "all_messages.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::test {

class AnyMessage {
 public:
  virtual ~AnyMessage() = default;
  [[nodiscard]] virtual const TypeDescription& type() const = 0;
  /// Of the same class, with nothing in it.
  [[nodiscard]] virtual std::unique_ptr<AnyMessage> fresh() const = 0;
  virtual bool read(std::span<const std::uint8_t> bytes, std::string* reason) = 0;
  virtual void write(std::vector<std::uint8_t>& bytes) const = 0;
  /// `other` is of the same class.
  [[nodiscard]] virtual bool equals(const AnyMessage& other) const = 0;
};

template <class M>
class MessageOf : public AnyMessage {
 public:
  [[nodiscard]] const TypeDescription& type() const override { return MessageTraits<M>::description(); }
  [[nodiscard]] std::unique_ptr<AnyMessage> fresh() const override { return std::make_unique<MessageOf>(); }
  bool read(std::span<const std::uint8_t> bytes, std::string* reason) override {
    return deserialize(bytes, message_, reason);
  }
  void write(std::vector<std::uint8_t>& bytes) const override { serialize(message_, bytes); }
  [[nodiscard]] bool equals(const AnyMessage& other) const override {
    return message_ == static_cast<const MessageOf&>(other).message_;
  }

 private:
  M message_;
};

/// One of each type of the build, in every layout.
inline std::vector<std::unique_ptr<AnyMessage>> every_message() {
  std::vector<std::unique_ptr<AnyMessage>> messages;
  for_each_message([&]<class M>() { messages.push_back(std::make_unique<MessageOf<M>>()); });
  return messages;
}

}  // namespace bw::test
