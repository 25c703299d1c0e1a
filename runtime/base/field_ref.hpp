// A field of a parameter struct whose C++ type is forgotten: what reading, listing and writing need of it. A
// visitor of fields is a FieldVisitor, compiled once; a struct is asked for its fields by that type alone, so
// that each source that uses the struct compiles its list once and not once for each reader and writer. Plain
// C++ only.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

class FieldRef;
class FieldVisitor;

template <class T>
concept HasFields = requires(T& t, FieldVisitor& visitor) {
  t.fields(visitor);
};

template <class T>
concept HasRule = requires(const T& t) {
  { t.violated_rule() } -> std::convertible_to<std::optional<std::string>>;
};

template <class T>
concept IntegerField = std::integral<T> && !std::same_as<T, bool>;

namespace detail {

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;

}  // namespace detail

template <class T>
concept ListField = detail::kIsVector<T>;

enum class FieldKind : std::uint8_t { boolean, integer, number, text, choice, section, list };

/// What can be done with a value of one type. Null where its kind has no such thing.
struct FieldType {
  using EachElement = std::function<void(FieldRef element)>;

  FieldKind kind;
  // integer
  std::int64_t lowest = 0, highest = 0;
  std::int64_t (*integer)(const void* value) = nullptr;
  void (*set_integer)(void* value, std::int64_t to) = nullptr;
  // choice
  std::vector<std::string_view> (*texts)() = nullptr;
  std::string_view (*text)(const void* value) = nullptr;
  void (*set_text)(void* value, std::string_view to) = nullptr;  ///< one of texts()
  // section
  void (*accept)(void* value, FieldVisitor& visitor) = nullptr;
  std::optional<std::string> (*violated_rule)(const void* value) = nullptr;
  bool leaves_other_keys = false;
  // list
  const FieldType& (*element)() = nullptr;
  std::size_t (*size)(const void* value) = nullptr;
  void (*each)(void* value, const EachElement& visit) = nullptr;
  /// `size` new elements, each handed to `fill`, in place of all that were there.
  void (*replace)(void* value, std::size_t size, const EachElement& fill) = nullptr;
};

class FieldRef {
 public:
  FieldRef(void* value, const FieldType& type) : value_(value), type_(&type) {}
  template <class T>
  static FieldRef of(T& value);

  const FieldType& type() const { return *type_; }
  FieldKind kind() const { return type_->kind; }

  bool& boolean() const { return *static_cast<bool*>(value_); }
  double& number() const { return *static_cast<double*>(value_); }
  std::string& text() const { return *static_cast<std::string*>(value_); }
  std::int64_t integer() const { return type_->integer(value_); }
  void set_integer(std::int64_t to) const { type_->set_integer(value_, to); }
  std::string_view choice() const { return type_->text(value_); }
  void set_choice(std::string_view to) const { type_->set_text(value_, to); }
  void accept(FieldVisitor& visitor) const { type_->accept(value_, visitor); }
  std::optional<std::string> violated_rule() const {
    return type_->violated_rule != nullptr ? type_->violated_rule(value_) : std::nullopt;
  }
  std::size_t size() const { return type_->size(value_); }
  void each(const FieldType::EachElement& visit) const { type_->each(value_, visit); }
  void replace(std::size_t size, const FieldType::EachElement& fill) const {
    type_->replace(value_, size, fill);
  }

 private:
  void* value_;
  const FieldType* type_;
};

/// What fields() is called with.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  template <class T>
  void operator()(std::string_view name, T& value, const Field& field = {}) {
    visit(name, FieldRef::of(value), field);
  }
  /// Names that were fields once; `instead` tells who still sets one what to do.
  virtual void retired(std::initializer_list<std::string_view>, std::string_view /*instead*/) {}

 private:
  virtual void visit(std::string_view name, FieldRef value, const Field& field) = 0;
};

namespace detail {

template <class T>
const FieldType& field_type_of();

template <IntegerField T>
constexpr FieldType integer_type() {
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  return {
      .kind = FieldKind::integer,
      .lowest = static_cast<std::int64_t>(std::numeric_limits<T>::min()),
      .highest = std::cmp_less(kMax, std::numeric_limits<T>::max())
                     ? kMax
                     : static_cast<std::int64_t>(std::numeric_limits<T>::max()),
      .integer = [](const void* value) { return static_cast<std::int64_t>(*static_cast<const T*>(value)); },
      .set_integer = [](void* value, std::int64_t to) { *static_cast<T*>(value) = static_cast<T>(to); }};
}

template <ChoiceField T>
constexpr FieldType choice_type() {
  return {.kind = FieldKind::choice,
          .texts = choice_texts<T>,
          .text = [](const void* value) { return text_of(*static_cast<const T*>(value)); },
          .set_text = [](void* value, std::string_view to) { *static_cast<T*>(value) = *choice_of<T>(to); }};
}

template <HasFields T>
constexpr FieldType section_type() {
  FieldType type{.kind = FieldKind::section, .accept = [](void* value, FieldVisitor& visitor) {
                   static_cast<T*>(value)->fields(visitor);
                 }};
  if constexpr (HasRule<T>) {
    type.violated_rule = [](const void* value) -> std::optional<std::string> {
      return static_cast<const T*>(value)->violated_rule();
    };
  }
  type.leaves_other_keys = requires { T::leaves_other_keys; };
  return type;
}

template <ListField T>
constexpr FieldType list_type() {
  using Element = typename T::value_type;
  return {.kind = FieldKind::list,
          .element = field_type_of<Element>,
          .size = [](const void* value) { return static_cast<const T*>(value)->size(); },
          .each =
              [](void* value, const FieldType::EachElement& visit) {
                T& list = *static_cast<T*>(value);
                for (std::size_t i = 0; i < list.size(); ++i) {
                  if constexpr (std::same_as<Element, bool>) {  // whose vector has no elements to point at
                    bool element = list[i];
                    visit(FieldRef::of(element));
                    list[i] = element;
                  } else {
                    visit(FieldRef::of(list[i]));
                  }
                }
              },
          .replace =
              [](void* value, std::size_t size, const FieldType::EachElement& fill) {
                T list;
                list.reserve(size);
                for (std::size_t i = 0; i < size; ++i) {
                  Element element{};
                  fill(FieldRef::of(element));
                  list.push_back(std::move(element));
                }
                *static_cast<T*>(value) = std::move(list);
              }};
}

template <class T>
constexpr FieldType field_type() {
  if constexpr (std::same_as<T, bool>) {
    return {.kind = FieldKind::boolean};
  } else if constexpr (IntegerField<T>) {
    return integer_type<T>();
  } else if constexpr (std::same_as<T, double>) {
    return {.kind = FieldKind::number};
  } else if constexpr (std::same_as<T, std::string>) {
    return {.kind = FieldKind::text};
  } else if constexpr (ChoiceField<T>) {
    return choice_type<T>();
  } else if constexpr (ListField<T>) {
    return list_type<T>();
  } else {
    static_assert(
        HasFields<T>,
        "a field is a bool, integer, double, string, enum with choice_table(), struct with fields(), "
        "or a vector of these");
    return section_type<T>();
  }
}

template <class T>
const FieldType& field_type_of() {
  static constexpr FieldType kType = field_type<T>();
  return kType;
}

}  // namespace detail

template <class T>
FieldRef FieldRef::of(T& value) {
  return {&value, detail::field_type_of<T>()};
}

}  // namespace bw
