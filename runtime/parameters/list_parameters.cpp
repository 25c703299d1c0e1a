#include "runtime/parameters/list_parameters.hpp"

#include <map>
#include <utility>

#include "runtime/parameters/write_parameters.hpp"

namespace bw {
namespace {

std::string type_name(const FieldType& type) {
  switch (type.kind) {
    case FieldKind::boolean:
      return "bool";
    case FieldKind::integer:
      return "integer";
    case FieldKind::number:
      return "double";
    case FieldKind::text:
    case FieldKind::choice:
      return "string";
    case FieldKind::list:
      return type_name(type.element()) + " list";
    case FieldKind::section:
      break;
  }
  return "struct";
}

class Lister final : public FieldVisitor {
 public:
  Lister(std::string path, std::vector<ParameterRow>& rows) : path_(std::move(path)), rows_(rows) {}

 private:
  void visit(std::string_view name, FieldRef value, const Field& field) override {
    list(joined(path_, name), value, field);
  }

  void list(const std::string& name, FieldRef value, const Field& field) {
    if (value.kind() == FieldKind::section) {
      Lister nested(name, rows_);
      return value.accept(nested);
    }
    const bool is_list_of_structs =
        value.kind() == FieldKind::list && value.type().element().kind == FieldKind::section;
    if (is_list_of_structs && value.size() > 0) {
      std::size_t index = 0;
      return value.each(
          [&](FieldRef element) { list(joined(name, std::to_string(index++)), element, field); });
    }
    const std::vector<std::string_view> allowed = texts_allowed(value.type(), field);
    rows_.push_back({name, type_name(value.type()), flow_text(value), "", std::string(field.unit), field.min,
                     field.max, std::vector<std::string>(allowed.begin(), allowed.end()), field.first,
                     std::string(field.doc)});
  }

  std::string path_;
  std::vector<ParameterRow>& rows_;
};

class NameLister final : public FieldVisitor {
 public:
  NameLister(std::string path, std::vector<std::string>& names) : path_(std::move(path)), names_(names) {}

 private:
  void visit(std::string_view name, FieldRef value, const Field&) override {
    list(joined(path_, name), value);
  }

  void list(const std::string& name, FieldRef value) {
    if (value.kind() == FieldKind::section) {
      NameLister nested(name, names_);
      return value.accept(nested);
    }
    if (value.kind() == FieldKind::list && value.type().element().kind == FieldKind::section)
      return value.replace(1, [&](FieldRef element) { list(name, element); });
    names_.push_back(name);
  }

  std::string path_;
  std::vector<std::string>& names_;
};

}  // namespace

std::vector<ParameterRow> list_parameters(FieldRef section, FieldRef defaults, std::string_view prefix) {
  std::vector<ParameterRow> rows, default_rows;
  Lister lister{std::string(prefix), rows}, default_lister{std::string(prefix), default_rows};
  section.accept(lister);
  defaults.accept(default_lister);
  std::map<std::string, std::string> text_of;
  for (const ParameterRow& row : default_rows) text_of[row.name] = row.value;
  for (ParameterRow& row : rows) {
    if (const auto found = text_of.find(row.name); found != text_of.end()) row.default_value = found->second;
  }
  return rows;
}

std::vector<std::string> parameter_names(FieldRef section) {
  std::vector<std::string> names;
  NameLister lister("", names);
  section.accept(lister);
  return names;
}

}  // namespace bw
