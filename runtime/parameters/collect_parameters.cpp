#include "runtime/parameters/collect_parameters.hpp"

#include <string_view>
#include <utility>

namespace bw {
namespace {

/// A list of which each element has a name of its own: ROS 2 knows no lists of structs or of lists.
bool is_named_list(const FieldType& type) {
  return type.kind == FieldKind::list &&
         (type.element().kind == FieldKind::section || type.element().kind == FieldKind::list);
}

template <class Element, class Read>
ParameterValue list_value(FieldRef list, Read read) {
  std::vector<Element> values;
  list.each([&](FieldRef element) { values.push_back(Element(read(element))); });
  return values;
}

ParameterValue leaf_value(FieldRef value) {
  switch (value.kind()) {
    case FieldKind::boolean:
      return value.boolean();
    case FieldKind::integer:
      return value.integer();
    case FieldKind::number:
      return value.number();
    case FieldKind::text:
      return value.text();
    case FieldKind::choice:
      return std::string(value.choice());
    case FieldKind::section:
      return {};
    case FieldKind::list:
      break;
  }
  switch (value.type().element().kind) {
    case FieldKind::boolean:
      return list_value<bool>(value, [](FieldRef element) { return element.boolean(); });
    case FieldKind::integer:
      return list_value<std::int64_t>(value, [](FieldRef element) { return element.integer(); });
    case FieldKind::number:
      return list_value<double>(value, [](FieldRef element) { return element.number(); });
    case FieldKind::choice:
      return list_value<std::string>(value, [](FieldRef element) { return element.choice(); });
    default:
      return list_value<std::string>(value, [](FieldRef element) { return element.text(); });
  }
}

class Collector final : public FieldVisitor {
 public:
  Collector(std::string path, std::string list, std::vector<ParameterEntry>& entries)
      : path_(std::move(path)), list_(std::move(list)), entries_(entries) {}

 private:
  void visit(std::string_view name, FieldRef value, const Field& field) override {
    add(joined(path_, name), list_, value, field);
  }

  void add(const std::string& name, const std::string& list, FieldRef value, const Field& field) {
    if (value.kind() == FieldKind::section) {
      Collector nested(name, list, entries_);
      return value.accept(nested);
    }
    if (is_named_list(value.type())) {
      std::size_t index = 0;
      return value.each([&](FieldRef element) {
        add(joined(name, std::to_string(index++)), list.empty() ? name : list, element, field);
      });
    }
    ParameterValue leaf = leaf_value(value);
    const ParameterType type = type_of(leaf);
    const IntegerRange limits{value.type().lowest, value.type().highest};
    entries_.push_back(
        {name, list, std::move(leaf), describe(type, field, limits, texts_allowed(value.type(), field))});
  }

  std::string path_;
  std::string list_;
  std::vector<ParameterEntry>& entries_;
};

}  // namespace

std::vector<ParameterEntry> collect_parameters(FieldRef section) {
  std::vector<ParameterEntry> entries;
  Collector collector("", "", entries);
  section.accept(collector);
  return entries;
}

}  // namespace bw
