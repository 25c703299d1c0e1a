// A parameter struct of any type, by value: that of a planner or a driver of another project, for instance.
// Whoever knows the type wraps it, AnyOptions(MyOptions{}); its fields are visited as those of any struct.
// Plain C++ only.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "runtime/base/field_ref.hpp"

namespace bw {

/// Empty: no fields.
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
  void fields(FieldVisitor& v) {
    if (held_) held_->section().accept(v);
  }
  std::optional<std::string> violated_rule() const {
    return held_ ? held_->section().violated_rule() : std::nullopt;
  }

 private:
  struct Holder {
    virtual ~Holder() = default;
    virtual std::unique_ptr<Holder> copy() const = 0;
    virtual FieldRef section() = 0;
  };
  template <class T>
  struct Held final : Holder {
    explicit Held(T v) : value(std::move(v)) {}
    std::unique_ptr<Holder> copy() const override { return std::make_unique<Held>(value); }
    FieldRef section() override { return FieldRef::of(value); }

    T value;
  };

  std::unique_ptr<Holder> held_;
};

}  // namespace bw
