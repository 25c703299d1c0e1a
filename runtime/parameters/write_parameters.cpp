#include "runtime/parameters/write_parameters.hpp"

#include <string_view>

#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

/// A struct on one line: {x: 1.0, y: 2.0}.
class FlowWriter final : public FieldVisitor {
 public:
  const std::string& text() const { return text_; }

 private:
  void visit(std::string_view name, FieldRef value, const Field&) override {
    text_.append(text_.empty() ? "" : ", ").append(name).append(": ").append(flow_text(value));
  }

  std::string text_;
};

/// A struct in block style; lists of structs have one line per element.
class BlockWriter final : public FieldVisitor {
 public:
  explicit BlockWriter(std::size_t indent) : margin_(indent, ' ') {}
  const std::string& text() const { return text_; }

 private:
  void visit(std::string_view name, FieldRef value, const Field&) override {
    text_.append(margin_).append(name).append(":");
    if (value.kind() == FieldKind::section) {
      BlockWriter nested(margin_.size() + 2);
      value.accept(nested);
      text_.append(nested.text_.empty() ? " {}\n" : "\n" + nested.text_);
      return;
    }
    const bool is_list_of_structs =
        value.kind() == FieldKind::list && value.type().element().kind == FieldKind::section;
    if (is_list_of_structs && value.size() > 0) {
      text_.append("\n");
      value.each([&](FieldRef element) {
        text_.append(margin_).append("  - ").append(flow_text(element)).append("\n");
      });
      return;
    }
    text_.append(" ").append(flow_text(value)).append("\n");
  }

  std::string margin_;
  std::string text_;
};

}  // namespace

std::string flow_text(FieldRef value) {
  switch (value.kind()) {
    case FieldKind::boolean:
      return to_text(value.boolean());
    case FieldKind::integer:
      return to_text(value.integer());
    case FieldKind::number:
      return to_text(value.number());
    case FieldKind::text:
      return to_text(value.text());
    case FieldKind::choice:
      return to_text(std::string(value.choice()));
    case FieldKind::section:
      break;
    case FieldKind::list: {
      std::string text;
      value.each([&](FieldRef element) { text.append(text.empty() ? "" : ", ").append(flow_text(element)); });
      return "[" + text + "]";
    }
  }
  FlowWriter writer;
  value.accept(writer);
  return "{" + writer.text() + "}";
}

std::string to_yaml(FieldRef section, std::size_t indent) {
  BlockWriter writer(indent);
  section.accept(writer);
  return writer.text().empty() ? std::string(indent, ' ') + "{}\n" : writer.text();
}

}  // namespace bw
