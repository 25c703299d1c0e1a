#include "runtime/recording/bag/schema.hpp"

#include <set>
#include <string_view>

namespace bw::bag {
namespace {

void add_contained(const TypeDescription& type, std::set<std::string_view>& done, std::string& text) {
  for (const FieldDescription& field : type.fields) {
    if (field.message == nullptr || !done.insert(field.message->ros_name).second) continue;
    const std::string_view name = field.message->ros_name;
    text += std::string(80, '=') + "\nMSG: ";
    text += std::string(name.substr(0, name.find('/'))) + std::string(name.substr(name.rfind('/'))) + "\n";
    text += field.message->definition;
    add_contained(*field.message, done, text);
  }
}

}  // namespace

std::string schema_text(const TypeDescription& type) {
  std::string text(type.definition);
  std::set<std::string_view> done = {type.ros_name};
  add_contained(type, done, text);
  return text;
}

}  // namespace bw::bag
