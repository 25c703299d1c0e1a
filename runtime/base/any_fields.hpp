// A parameter struct whose type is not known where it is read, listed and written: that of a planner of another
// project, for instance. Whoever knows the type wraps it, AnyOptions(MyOptions{}); whoever has a visitor of fields
// calls fields(visitor) on that as on any struct. Plain C++ only.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

class FieldVisitor;

/// Fields behind an interface.
class FieldGroup {
 public:
  virtual ~FieldGroup() = default;
  virtual void accept(FieldVisitor& visitor) = 0;
  virtual std::optional<std::string> violated_rule() const = 0;

  template <class Visitor>
  void fields(Visitor& v);
};

/// A visitor of fields behind an interface. A field may be bool, an integer, double, std::string, an enum with a
/// table, a struct of such fields, or a std::vector of std::int64_t, double or std::string.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  template <class T>
  void operator()(std::string_view name, T& value, const Field& field = {});

 protected:
  virtual void visit(std::string_view name, bool& value, const Field& field) = 0;
  virtual void visit(std::string_view name, std::int64_t& value, const Field& field) = 0;
  virtual void visit(std::string_view name, double& value, const Field& field) = 0;
  virtual void visit(std::string_view name, std::string& value, const Field& field) = 0;
  virtual void visit(std::string_view name, std::vector<std::int64_t>& value, const Field& field) = 0;
  virtual void visit(std::string_view name, std::vector<double>& value, const Field& field) = 0;
  virtual void visit(std::string_view name, std::vector<std::string>& value, const Field& field) = 0;
  virtual void visit(std::string_view name, FieldGroup& value, const Field& field) = 0;
};

namespace detail {

/// The fields of a struct that somebody else holds.
template <class T>
class GroupOf final : public FieldGroup {
 public:
  explicit GroupOf(T& value) : value_(value) {}
  void accept(FieldVisitor& visitor) override { value_.fields(visitor); }
  std::optional<std::string> violated_rule() const override {
    if constexpr (requires { value_.violated_rule(); })
      return value_.violated_rule();
    else
      return std::nullopt;
  }

 private:
  T& value_;
};

/// Hands every field to a visitor of any type.
template <class Visitor>
class Forwarder final : public FieldVisitor {
 public:
  explicit Forwarder(Visitor& visitor) : visitor_(visitor) {}

 private:
  void visit(std::string_view n, bool& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, std::int64_t& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, double& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, std::string& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, std::vector<std::int64_t>& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, std::vector<double>& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, std::vector<std::string>& v, const Field& f) override { visitor_(n, v, f); }
  void visit(std::string_view n, FieldGroup& v, const Field& f) override { visitor_(n, v, f); }

  Visitor& visitor_;
};

/// The range of a field within what its integer type can hold.
template <std::integral T>
Field within_type(Field field) {
  field.min = std::max(field.min, static_cast<double>(std::numeric_limits<T>::min()));
  field.max = std::min(field.max, static_cast<double>(std::numeric_limits<T>::max()));
  return field;
}

}  // namespace detail

template <class Visitor>
void FieldGroup::fields(Visitor& v) {
  detail::Forwarder<Visitor> forwarder(v);
  accept(forwarder);
}

template <class T>
void FieldVisitor::operator()(std::string_view name, T& value, const Field& field) {
  if constexpr (ChoiceField<T>) {
    std::string text(text_of(value));
    Field texts = field;
    texts.choices = choice_texts<T>();
    visit(name, text, texts);
    if (const std::optional<T> read = choice_of<T>(text)) value = *read;
  } else if constexpr (requires(FieldVisitor & self) { value.fields(self); }) {
    detail::GroupOf<T> group(value);
    visit(name, static_cast<FieldGroup&>(group), field);
  } else if constexpr (std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, std::int64_t>) {
    static_assert(sizeof(T) < sizeof(std::int64_t), "use std::int64_t");
    std::int64_t wide = value;
    visit(name, wide, detail::within_type<T>(field));
    value = static_cast<T>(wide);
  } else {
    visit(name, value, field);
  }
}

/// A parameter struct of any type, by value. Empty: no fields.
class AnyOptions {
 public:
  AnyOptions() = default;
  template <class T>
  requires(!std::same_as<T, AnyOptions>) explicit AnyOptions(T value)
      : held_(std::make_unique<Held<T>>(std::move(value))) {}
  AnyOptions(const AnyOptions& other) : held_(other.held_ ? other.held_->copy() : nullptr) {}
  AnyOptions(AnyOptions&&) noexcept = default;
  AnyOptions& operator=(AnyOptions other) noexcept {
    held_ = std::move(other.held_);
    return *this;
  }
  ~AnyOptions() = default;

  /// Throws std::bad_cast when it holds another type.
  template <class T>
  const T& as() const {
    return dynamic_cast<const Held<T>&>(*held_).value;
  }

  bool empty() const { return held_ == nullptr; }
  template <class Visitor>
  void fields(Visitor& v) {
    if (held_) held_->group().fields(v);
  }
  std::optional<std::string> violated_rule() const {
    return held_ ? held_->group().violated_rule() : std::nullopt;
  }

 private:
  struct Holder {
    virtual ~Holder() = default;
    virtual std::unique_ptr<Holder> copy() const = 0;
    virtual FieldGroup& group() = 0;
  };
  template <class T>
  struct Held final : Holder {
    explicit Held(T v) : value(std::move(v)) {}
    std::unique_ptr<Holder> copy() const override { return std::make_unique<Held>(value); }
    FieldGroup& group() override { return fields_of_value; }

    T value;
    detail::GroupOf<T> fields_of_value{value};
  };

  std::unique_ptr<Holder> held_;
};

}  // namespace bw
