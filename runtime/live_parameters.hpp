// The parameters of one node while it runs: who may change what, and when. All calls on the component's lane,
// between its callbacks.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/parameter_set.hpp"
#include "runtime/ports.hpp"

namespace bw {

/// Hears of a new snapshot. A std::runtime_error refuses it: it is called again with the old one.
using OnParameters = std::function<void(const ParameterSet& snapshot, const Tick& tick)>;

/// What a component declares of its own parameters.
struct ParameterDeclaration {
  ParameterSet values;
  OnParameters on_change;               ///< empty: nothing may change while the component is configured
  std::vector<std::string> fixed = {};  ///< names, or sections of names, that may not either
};

class LiveParameters {
 public:
  /// `component` is named in refusals.
  explicit LiveParameters(std::string component = {}) : component_(std::move(component)) {}

  /// What is there instead of earlier ones of the same kind, as after a second configure(). Throws
  /// std::logic_error for a fixed name that the struct does not have.
  void declare(ParameterDeclaration declaration);
  /// Parameters that are never changed here, under `prefix` (empty: none); `why` ends their refusals.
  void declare_read_only(const std::string& prefix, ParameterSet values, std::string why);

  /// False from cleanup() to the next configure(): every parameter of the component may change, and nobody is
  /// called.
  void set_configured(bool configured) { configured_ = configured; }
  /// What was changed goes into the section that the next configure() reads.
  void write_changes(ConfigNode& section) const { own_.values.write_changes(section); }

  struct Parameter {
    std::string name;
    ParameterValue value;
    ParameterDescriptor descriptor;  ///< read_only as it is now
  };
  /// The component's own in the order of its field lists, then the others.
  std::vector<std::string> names() const;
  std::optional<Parameter> find(std::string_view name) const;

  struct Outcome {
    std::vector<std::string> refusals;  ///< one for each change asked for; empty: accepted
    std::vector<NamedValue> changed;    ///< what is now different, for those who follow /parameter_events
  };
  /// One after the other, each judged with those accepted before; then the component is called once. When it
  /// refuses, all are refused.
  Outcome change_each(std::span<const NamedValue> changes, const Tick& tick);
  /// All or none; one refusal for the whole.
  Outcome change_all(std::span<const NamedValue> changes, const Tick& tick);

 private:
  struct ReadOnly {
    std::string prefix;
    ParameterSet values;
    std::string why;
  };

  bool may_change(std::string_view name) const;
  bool is_fixed(std::string_view name) const;
  /// Of a parameter that may not change; nothing when it would stay as it is.
  std::optional<std::string> refusal_of_fixed(const NamedValue& wanted) const;
  /// Makes `next` the snapshot if the component takes it; else its reason.
  std::optional<std::string> take(ParameterSet next, const Tick& tick);

  std::string component_;
  ParameterDeclaration own_;
  std::vector<ReadOnly> read_only_;
  bool configured_ = true;
};

}  // namespace bw
