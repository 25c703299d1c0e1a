#include "runtime/live_parameters.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace bw {
namespace {

/// `name` is `section`, or lies in it.
bool lies_in(std::string_view name, std::string_view section) {
  return name.starts_with(section) && (name.size() == section.size() || name[section.size()] == '.');
}

LiveParameters::Parameter parameter_of(const ParameterSet& set, std::size_t index, const std::string& name) {
  return {name, set.value(index), set.descriptor(index)};
}

/// Of the parameters named in `changes`, those that are not the same in both.
std::vector<NamedValue> differences(const ParameterSet& before, const ParameterSet& after,
                                    std::span<const NamedValue> changes) {
  std::vector<NamedValue> different;
  std::set<std::size_t> told;
  for (const NamedValue& change : changes) {
    const auto index = after.find(change.name);
    if (!index || after.value(*index) == before.value(*index) || !told.insert(*index).second) continue;
    different.push_back({change.name, after.value(*index)});
  }
  return different;
}

}  // namespace

void LiveParameters::declare(ParameterDeclaration declaration) {
  for (const std::string& name : declaration.fixed) {
    if (!declaration.values.has(name))
      throw std::logic_error(component_ + ": no parameter or section is called " + name);
  }
  own_ = std::move(declaration);
}

void LiveParameters::declare_read_only(const std::string& prefix, ParameterSet values, std::string why) {
  std::erase_if(read_only_, [&prefix](const ReadOnly& section) { return section.prefix == prefix; });
  read_only_.push_back({prefix, std::move(values), std::move(why)});
}

std::vector<std::string> LiveParameters::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < own_.values.size(); ++i) names.push_back(own_.values.name(i));
  for (const ReadOnly& section : read_only_) {
    for (std::size_t i = 0; i < section.values.size(); ++i) {
      // A section within another: both may read one key.
      const std::string name = joined(section.prefix, section.values.name(i));
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

bool LiveParameters::may_change(std::string_view name) const {
  if (!configured_) return true;
  return own_.on_change && std::ranges::none_of(own_.fixed, [name](const std::string& section) {
           return lies_in(name, section);
         });
}

std::optional<LiveParameters::Parameter> LiveParameters::find(std::string_view name) const {
  if (const auto index = own_.values.find(name)) {
    Parameter found = parameter_of(own_.values, *index, std::string(name));
    found.descriptor.read_only = !may_change(name);
    return found;
  }
  for (const ReadOnly& section : read_only_) {
    if (!section.prefix.empty() && (!lies_in(name, section.prefix) || name == section.prefix)) continue;
    const std::size_t start = section.prefix.empty() ? 0 : section.prefix.size() + 1;
    const auto index = section.values.find(name.substr(start));
    if (!index) continue;
    Parameter found = parameter_of(section.values, *index, std::string(name));
    found.descriptor.read_only = true;
    return found;
  }
  return std::nullopt;
}

bool LiveParameters::is_fixed(std::string_view name) const {
  return own_.values.find(name) ? !may_change(name) : find(name).has_value();
}

std::optional<std::string> LiveParameters::refusal_of_fixed(const NamedValue& wanted) const {
  // So that what was written down of a node can be given back to it.
  if (find(wanted.name)->value == wanted.value) return std::nullopt;
  if (own_.values.find(wanted.name))
    return wanted.name + " may not change while " + component_ + " is active; deactivate and clean up first";
  const auto section = std::ranges::find_if(read_only_, [&wanted](const ReadOnly& s) {
    return s.prefix.empty() ? s.values.find(wanted.name).has_value() : lies_in(wanted.name, s.prefix);
  });
  return wanted.name + " is read-only: " + section->why;
}

std::optional<std::string> LiveParameters::take(ParameterSet next, const Tick& tick) {
  if (configured_ && own_.on_change) {
    try {
      own_.on_change(next, tick);
    } catch (const std::runtime_error& error) {
      own_.on_change(own_.values, tick);
      return component_ + " does not take it: " + error.what();
    }
  }
  own_.values = std::move(next);
  return std::nullopt;
}

LiveParameters::Outcome LiveParameters::change_each(std::span<const NamedValue> changes, const Tick& tick) {
  Outcome outcome;
  ParameterSet next = own_.values;
  for (const NamedValue& wanted : changes) {
    const auto why = is_fixed(wanted.name) ? refusal_of_fixed(wanted) : next.change({&wanted, 1});
    outcome.refusals.push_back(why.value_or(""));
  }
  outcome.changed = differences(own_.values, next, changes);
  if (outcome.changed.empty()) return outcome;
  if (const auto why = take(std::move(next), tick)) {
    for (std::string& refusal : outcome.refusals) {
      if (refusal.empty()) refusal = *why;
    }
    outcome.changed.clear();
  }
  return outcome;
}

LiveParameters::Outcome LiveParameters::change_all(std::span<const NamedValue> changes, const Tick& tick) {
  std::vector<NamedValue> free;
  for (const NamedValue& wanted : changes) {
    if (!is_fixed(wanted.name)) {
      free.push_back(wanted);
    } else if (const auto why = refusal_of_fixed(wanted)) {
      return {{*why}, {}};
    }
  }
  ParameterSet next = own_.values;
  if (const auto why = next.change(free)) return {{*why}, {}};
  std::vector<NamedValue> changed = differences(own_.values, next, free);
  if (changed.empty()) return {{""}, {}};
  if (const auto why = take(std::move(next), tick)) return {{*why}, {}};
  return {{""}, std::move(changed)};
}

}  // namespace bw
