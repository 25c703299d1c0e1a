#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/client_ops.hpp"
#include "runtime/remote/foxglove/json_bounds.hpp"
#include "runtime/remote/foxglove/parameter_json.hpp"

namespace bw::foxglove {
namespace {

using nlohmann::json;
using Kind = ProtocolError::Kind;

/// A value in a message for people.
std::string shown(const json& value) {
  constexpr std::size_t kMax = 40;
  if (value.is_structured()) return value.is_array() ? "an array" : "an object";
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kMax) text.replace(kMax, std::string::npos, "...");
  return text;
}

/// The fields of an object; the first that is wrong is kept, and what is read after it is empty.
class Fields {
 public:
  Fields(const json& object, std::string where, std::optional<ProtocolError>& error)
      : object_(object), where_(std::move(where)), error_(error) {
    if (!object_.is_object()) refuse(where_, object_, "must be an object");
  }

  std::uint32_t number(const char* name) const {
    const json* value = find(name);
    return value == nullptr ? 0 : number_of(*value, path(name));
  }

  std::string text(const char* name) const {
    const json* value = find(name);
    return value == nullptr ? std::string() : text_of(*value, path(name));
  }

  std::optional<std::string> optional_text(const char* name) const {
    if (!object_.is_object() || !object_.contains(name) || object_.at(name).is_null()) return std::nullopt;
    return text_of(object_.at(name), path(name));
  }

  std::vector<std::uint32_t> numbers(const char* name) const {
    std::vector<std::uint32_t> values;
    for_each(name, [&](const json& value, std::string where) { values.push_back(number_of(value, where)); });
    return values;
  }

  std::vector<std::string> texts(const char* name) const {
    std::vector<std::string> values;
    for_each(name, [&](const json& value, std::string where) { values.push_back(text_of(value, where)); });
    return values;
  }

  /// Calls on(fields) for each object of the array.
  template <class On>
  void objects(const char* name, On on) const {
    for_each(name,
             [&](const json& value, std::string where) { on(Fields(value, std::move(where), error_)); });
  }

  ParameterValue parameter_value() const {
    if (error_ || !object_.contains("value") || object_.at("value").is_null()) return {};
    auto value = parameter_value_of(object_.at("value"), optional_text("type"));
    if (const auto* rule = std::get_if<BrokenRule>(&value)) {
      refuse(path("value"), object_.at("value"), rule->text);
      return {};
    }
    return std::get<ParameterValue>(std::move(value));
  }

 private:
  std::string path(const char* name) const { return where_.empty() ? name : where_ + "." + name; }

  void refuse(const std::string& where, const json& value, std::string_view rule) const {
    if (!error_) error_ = {Kind::bad_field, fmt::format("{} = {}: {}", where, shown(value), rule)};
  }

  const json* find(const char* name) const {
    if (error_) return nullptr;
    const auto found = object_.find(name);
    if (found != object_.end()) return &*found;
    error_ = {Kind::bad_field, path(name) + " is missing"};
    return nullptr;
  }

  std::uint32_t number_of(const json& value, const std::string& where) const {
    constexpr auto kMax = std::numeric_limits<std::uint32_t>::max();
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= kMax) return value.get<std::uint32_t>();
    refuse(where, value, "must be a whole number from 0 to 4294967295");
    return 0;
  }

  std::string text_of(const json& value, const std::string& where) const {
    if (value.is_string()) return value.get<std::string>();
    refuse(where, value, "must be a string");
    return {};
  }

  template <class On>
  void for_each(const char* name, On on) const {
    const json* values = find(name);
    if (values == nullptr) return;
    if (!values->is_array()) return refuse(path(name), *values, "must be an array");
    for (std::size_t i = 0; i < values->size() && !error_; ++i)
      on((*values)[i], fmt::format("{}[{}]", path(name), i));
  }

  const json& object_;
  std::string where_;
  std::optional<ProtocolError>& error_;
};

TextOp subscribe(const Fields& fields) {
  Subscribe op;
  fields.objects("subscriptions", [&op](const Fields& subscription) {
    op.subscriptions.push_back({subscription.number("id"), subscription.number("channelId")});
  });
  return op;
}

TextOp advertise(const Fields& fields) {
  Advertise op;
  fields.objects("channels", [&op](const Fields& channel) {
    op.channels.push_back(
        {channel.number("id"), channel.text("topic"), channel.text("encoding"), channel.text("schemaName")});
  });
  return op;
}

TextOp set_parameters(const Fields& fields) {
  SetParameters op;
  fields.objects("parameters", [&op](const Fields& parameter) {
    op.parameters.push_back({parameter.text("name"), parameter.parameter_value()});
  });
  op.request = fields.optional_text("id");
  return op;
}

struct Reader {
  std::string_view op;
  TextOp (*read)(const Fields&);
};
constexpr std::array<Reader, 11> kReaders = {{
    {"subscribe", subscribe},
    {"unsubscribe", [](const Fields& f) -> TextOp { return Unsubscribe{f.numbers("subscriptionIds")}; }},
    {"advertise", advertise},
    {"unadvertise", [](const Fields& f) -> TextOp { return Unadvertise{f.numbers("channelIds")}; }},
    {"getParameters",
     [](const Fields& f) -> TextOp {
       return GetParameters{f.texts("parameterNames"), f.optional_text("id")};
     }},
    {"setParameters", set_parameters},
    {"subscribeParameterUpdates",
     [](const Fields& f) -> TextOp { return SubscribeParameterUpdates{f.texts("parameterNames")}; }},
    {"unsubscribeParameterUpdates",
     [](const Fields& f) -> TextOp { return UnsubscribeParameterUpdates{f.texts("parameterNames")}; }},
    {"subscribeConnectionGraph", [](const Fields&) -> TextOp { return SubscribeConnectionGraph{}; }},
    {"unsubscribeConnectionGraph", [](const Fields&) -> TextOp { return UnsubscribeConnectionGraph{}; }},
    {"fetchAsset",
     [](const Fields& f) -> TextOp {
       return FetchAsset{f.text("uri"), f.number("requestId")};
     }},
}};

}  // namespace

std::variant<TextOp, ProtocolError> decode_text(std::string_view text) {
  if (text.size() > kLongestText)
    return ProtocolError{Kind::too_large,
                         fmt::format("a text of {} bytes: at most {} are taken", text.size(), kLongestText)};
  if (const auto broken = broken_bound(text, kDeepestText, kLongestText))
    return ProtocolError{Kind::too_large, "a text " + *broken};
  const json message = json::parse(text, nullptr, false);
  if (message.is_discarded()) return ProtocolError{Kind::not_json, "a text that is not JSON"};
  if (!message.is_object() || !message.contains("op") || !message.at("op").is_string())
    return ProtocolError{Kind::no_op, "a text without a field op that is a string"};

  const auto& name = message.at("op").get_ref<const std::string&>();
  for (const Reader& reader : kReaders) {
    if (reader.op != name) continue;
    std::optional<ProtocolError> error;
    TextOp op = reader.read(Fields(message, "", error));
    if (!error) return op;
    return ProtocolError{error->kind, name + ": " + error->message};
  }
  return ProtocolError{Kind::unknown_op, "op = " + shown(message.at("op")) + ": no such op"};
}

}  // namespace bw::foxglove
