#include "runtime/wire/leaves.hpp"

#include <string_view>

#include <fmt/format.h>

#include "runtime/wire/cdr_reader.hpp"
#include "runtime/wire/validate.hpp"

namespace bw {
namespace {

/// Walks a validated message: reads cannot fail.
class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> cdr) : reader_(cdr) { static_cast<void>(reader_.open()); }

  void fields(const TypeDescription& type, const std::string& prefix) {
    for (const FieldDescription& field : type.fields) {
      const std::string path =
          prefix.empty() ? std::string(field.name) : prefix + "." + std::string(field.name);
      if (field.shape == Shape::kSingle) {
        element(field, path);
        continue;
      }
      std::uint32_t count = field.capacity;
      if (field.shape == Shape::kSequence) {
        count = take<std::uint32_t>();
        leaves.push_back({path + ".size()", std::uint64_t{count}});
      }
      for (std::uint32_t i = 0; i < count; ++i) element(field, path + "[" + std::to_string(i) + "]");
    }
  }

  std::vector<Leaf> leaves;

 private:
  void element(const FieldDescription& field, const std::string& path) {
    if (field.kind == Kind::kMessage) {
      fields(*field.message, path);
    } else {
      leaves.push_back({path, scalar(field.kind)});
    }
  }

  LeafValue scalar(Kind kind) {
    switch (kind) {
      case Kind::kBoolean:
        return take<std::uint8_t>() != 0;
      case Kind::kByte:
      case Kind::kUint8:
        return std::uint64_t{take<std::uint8_t>()};
      case Kind::kInt8:
        return std::int64_t{take<std::int8_t>()};
      case Kind::kInt16:
        return std::int64_t{take<std::int16_t>()};
      case Kind::kUint16:
        return std::uint64_t{take<std::uint16_t>()};
      case Kind::kInt32:
        return std::int64_t{take<std::int32_t>()};
      case Kind::kUint32:
        return std::uint64_t{take<std::uint32_t>()};
      case Kind::kInt64:
        return take<std::int64_t>();
      case Kind::kUint64:
        return take<std::uint64_t>();
      case Kind::kFloat32:
        return double{take<float>()};
      case Kind::kFloat64:
        return take<double>();
      case Kind::kString:
        return std::string(take<std::string_view>());
      case Kind::kMessage:
        break;
    }
    return false;
  }

  template <class T>
  T take() {
    T value{};
    static_cast<void>(reader_.read(value));
    return value;
  }

  CdrReader reader_;
};

}  // namespace

std::vector<Leaf> leaves_of(const TypeDescription& type, std::span<const std::uint8_t> cdr) {
  if (!validate(type, cdr)) return {};
  Walk walk(cdr);
  walk.fields(type, "");
  return std::move(walk.leaves);
}

std::string to_text(const LeafValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>) {
          return "\"" + v + "\"";
        } else {
          return fmt::format("{}", v);
        }
      },
      value);
}

}  // namespace bw
