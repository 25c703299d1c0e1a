// Generated classes behind one interface: what walks many of them is compiled once, not once for each.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "runtime/wire/serialization.hpp"
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

}  // namespace bw::test
