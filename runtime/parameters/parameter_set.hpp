// The parameters of a node as ROS 2 sees them: a snapshot of a struct with fields(v), taken apart into typed
// leaves with names, and changed leaf by leaf through the very checks that YAML goes through
// (read_parameters.hpp). A value type: a change makes a new snapshot or nothing.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/parameters/collect_parameters.hpp"
#include "runtime/parameters/config_writer.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {

struct NamedValue {
  std::string name;
  ParameterValue value;
  bool operator==(const NamedValue&) const = default;
};

class ParameterSet {
 public:
  /// Empty: no parameters.
  ParameterSet() = default;
  template <HasFields P>
  explicit ParameterSet(P value) : ParameterSet(collect_parameters(value)) {
    held_ = std::make_shared<Held<P>>(std::move(value));
  }

  /// The struct of which it is a snapshot. Throws std::bad_cast when it is of another type.
  template <class P>
  const P& as() const {
    return dynamic_cast<const Held<P>&>(*held_).value;
  }

  std::size_t size() const { return values_.size(); }
  /// In the order of the field lists.
  const std::string& name(std::size_t index) const { return leaves_->entries[index].name; }
  const ParameterValue& value(std::size_t index) const { return values_[index]; }
  const ParameterDescriptor& descriptor(std::size_t index) const {
    return leaves_->entries[index].descriptor;
  }
  std::optional<std::size_t> find(std::string_view name) const;
  /// Whether it is a parameter, or the name of a section or list of them that may be empty.
  bool has(std::string_view name) const;

  /// All of them or none, in one step: rules over several fields see all. Returns the reason of a refusal:
  /// parameter, value and rule. A value must have the type of its parameter: an integer is no double (as in
  /// rclcpp); an empty list is one of any type.
  [[nodiscard]] std::optional<std::string> change(std::span<const NamedValue> changes);

  /// Puts what was changed since the construction into the section that the struct was read from, so that
  /// reading it again gives this snapshot.
  void write_changes(ConfigNode& section) const;

 private:
  struct Holder {
    virtual ~Holder() = default;
    /// Null when there are violations.
    virtual std::shared_ptr<const Holder> changed(const ConfigNode& section,
                                                  std::vector<Violation>& violations) const = 0;
    virtual ConfigNode config() const = 0;
  };
  template <class P>
  struct Held final : Holder {
    explicit Held(P v) : value(std::move(v)) {}
    std::shared_ptr<const Holder> changed(const ConfigNode& section,
                                          std::vector<Violation>& violations) const override {
      auto next = std::make_shared<Held>(value);
      read_into(next->value, section, "", violations);
      return violations.empty() ? next : nullptr;
    }
    ConfigNode config() const override {
      P copy = value;  // fields() wants to be able to change it
      return to_config(FieldRef::of(copy));
    }
    P value;
  };
  struct Leaves {
    std::vector<ParameterEntry> entries;
    std::map<std::string, std::size_t, std::less<>> index_of;
  };

  explicit ParameterSet(std::vector<ParameterEntry> entries);
  std::string unknown(std::string_view name) const;
  void put(ConfigNode& section, std::size_t index, const ParameterValue& value, const Holder& lists) const;

  std::shared_ptr<const Holder> held_;
  std::shared_ptr<const Leaves> leaves_ = std::make_shared<Leaves>();
  std::vector<ParameterValue> values_;  ///< of the leaves now
  std::set<std::size_t> changed_;
};

}  // namespace bw
