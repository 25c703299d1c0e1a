#include "runtime/parameters/config_writer.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "runtime/parameters/parameter_value.hpp"

namespace bw {
namespace {

ConfigNode node_of(ConfigNode::Kind kind) { return {.kind = kind, .where = {std::string(kOverrideFile), 0}}; }

class ConfigWriter final : public FieldVisitor {
 public:
  ConfigNode take() { return std::move(root_); }

 private:
  void visit(std::string_view name, FieldRef value, const Field&) override {
    root_.map.push_back({std::string(name), root_.where, to_config(value)});
  }

  ConfigNode root_ = node_of(ConfigNode::Kind::kMap);
};

}  // namespace

ConfigNode to_config(FieldRef value) {
  switch (value.kind()) {
    case FieldKind::boolean:
      return to_config_node(value.boolean());
    case FieldKind::integer:
      return to_config_node(value.integer());
    case FieldKind::number:
      return to_config_node(value.number());
    case FieldKind::text:
      return to_config_node(value.text());
    case FieldKind::choice:
      return to_config_node(std::string(value.choice()));
    case FieldKind::section:
      break;
    case FieldKind::list: {
      ConfigNode list = node_of(ConfigNode::Kind::kSequence);
      value.each([&](FieldRef element) { list.sequence.push_back(to_config(element)); });
      return list;
    }
  }
  ConfigWriter writer;
  value.accept(writer);
  return writer.take();
}

}  // namespace bw
