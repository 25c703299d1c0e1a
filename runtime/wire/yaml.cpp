#include "runtime/wire/yaml.hpp"

#include <algorithm>

#include "runtime/wire/cdr_reader.hpp"
#include "runtime/wire/validate.hpp"
#include "runtime/wire/yaml_scalar.hpp"

namespace bw {
namespace {

constexpr std::size_t kLongest =
    128;  // elements of an array or characters of a text, as `ros2 topic echo` has it

bool is_empty(const TypeDescription& type) {
  return type.fields.size() == 1 && type.fields[0].name == kEmptyMessageMember;
}

/// Walks a validated message: reads cannot fail.
class Printer {
 public:
  explicit Printer(std::span<const std::uint8_t> cdr) : reader_(cdr) { static_cast<void>(reader_.open()); }

  std::string print(const TypeDescription& type) {
    if (is_empty(type)) return "{}\n";
    fields(type, 0);
    return std::move(out_);
  }

 private:
  /// The cursor is at column `indent` of an empty line.
  void fields(const TypeDescription& type, std::size_t indent) {
    for (const FieldDescription& field : type.fields) {
      if (&field != &type.fields.front()) new_line(indent);
      put(field.name);
      put(":");
      if (field.shape == Shape::kSingle) {
        value(field, indent, true);
      } else {
        list(field, indent);
      }
    }
    if (indent == 0) put("\n");
  }

  void list(const FieldDescription& field, std::size_t indent) {
    std::uint32_t count = field.capacity;
    if (field.shape == Shape::kSequence) count = take<std::uint32_t>();
    if (count == 0) put(" []");
    const bool silent = silent_;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i == kLongest) silent_ = true;
      new_line(indent);
      put("-");
      value(field, indent, false);
    }
    silent_ = silent;
    if (count > kLongest) {
      new_line(indent);
      put("- '...'");
    }
  }

  /// One element, after "name:" or "-" of a line at `indent`.
  void value(const FieldDescription& field, std::size_t indent, bool after_name) {
    if (field.kind != Kind::kMessage) {
      put(" ");
      scalar(field.kind, indent + 2);
    } else if (is_empty(*field.message)) {
      static_cast<void>(take<std::uint8_t>());
      put(" {}");
    } else {
      if (after_name) {
        new_line(indent + 2);
      } else {
        put(" ");
      }
      fields(*field.message, indent + 2);
    }
  }

  void scalar(Kind kind, std::size_t indent) {
    switch (kind) {
      case Kind::kBoolean:
        return put(take<std::uint8_t>() != 0 ? "true" : "false");
      case Kind::kByte:
        return octet(take<std::uint8_t>(), indent);
      case Kind::kInt8:
        return put(std::to_string(take<std::int8_t>()));
      case Kind::kUint8:
        return put(std::to_string(take<std::uint8_t>()));
      case Kind::kInt16:
        return put(std::to_string(take<std::int16_t>()));
      case Kind::kUint16:
        return put(std::to_string(take<std::uint16_t>()));
      case Kind::kInt32:
        return put(std::to_string(take<std::int32_t>()));
      case Kind::kUint32:
        return put(std::to_string(take<std::uint32_t>()));
      case Kind::kInt64:
        return put(std::to_string(take<std::int64_t>()));
      case Kind::kUint64:
        return put(std::to_string(take<std::uint64_t>()));
      case Kind::kFloat32:
        return number(take<float>());
      case Kind::kFloat64:
        return number(take<double>());
      case Kind::kString:
        return text(take<std::string_view>(), indent);
      case Kind::kMessage:
        return;
    }
  }

  void number(double value) {
    if (!silent_) out_ += yaml_number(value);
  }
  void text(std::string_view utf8, std::size_t indent) {
    if (!silent_) out_ += yaml_text(utf8, kLongest, indent);
  }
  /// Python holds an octet as the character of that code.
  void octet(std::uint8_t value, std::size_t indent) {
    const char utf8[] = {static_cast<char>(0xC0U | value >> 6U), static_cast<char>(0x80U | (value & 0x3FU))};
    const char ascii = static_cast<char>(value);
    text(value < 0x80 ? std::string_view(&ascii, 1) : std::string_view(utf8, 2), indent);
  }

  void new_line(std::size_t indent) {
    put("\n");
    if (!silent_) out_.append(indent, ' ');
  }
  void put(std::string_view words) {
    if (!silent_) out_ += words;
  }

  template <class T>
  T take() {
    T value{};
    static_cast<void>(reader_.read(value));
    return value;
  }

  CdrReader reader_;
  std::string out_;
  bool silent_ = false;  // beyond the end of a shortened array
};

}  // namespace

std::string to_yaml(const TypeDescription& type, std::span<const std::uint8_t> cdr) {
  std::string error;
  if (!validate(type, cdr, &error)) return "# " + error + "\n";
  return Printer(cdr).print(type);
}

}  // namespace bw
