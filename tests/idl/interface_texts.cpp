#include "tests/idl/interface_texts.hpp"

#include <array>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include <openssl/sha.h>

namespace bw::test {
namespace {

using Fields = std::vector<TextField>;

const std::map<std::string, int> kTypeIds = {
    {"int8", 2},     {"uint8", 3},  {"char", 3},  {"int16", 4},   {"uint16", 5},
    {"int32", 6},    {"uint32", 7}, {"int64", 8}, {"uint64", 9},  {"float32", 10},
    {"float64", 11}, {"bool", 15},  {"byte", 16}, {"string", 17},
};

TextField field(const std::string& name, const std::string& nested, std::uint64_t at_most = 0) {
  return {name, at_most == 0 ? 1 : 97, at_most, 0, nested};
}

/// Of a line without its comment; nothing of a constant.
void parse_line(const std::string& line, const std::string& package, Fields& fields) {
  static const std::regex constant(R"(^\s*[a-z0-9]+\s+([A-Z]([A-Z0-9_]?[A-Z0-9]+)*)\s*=\s*-?[0-9.]+\s*$)");
  static const std::regex member(
      R"(^\s*(?:([a-z][a-z0-9_]*)/)?([A-Za-z][A-Za-z0-9]*)(?:<=([0-9]+))?(?:\[(<=)?([0-9]*)\])?\s+([a-z][a-z0-9_]*)\s*$)");
  std::smatch part;
  if (line.find_first_not_of(" \t") == std::string::npos || std::regex_match(line, constant)) return;
  if (!std::regex_match(line, part, member)) throw std::runtime_error("neither field nor constant: " + line);
  TextField result;
  result.name = part[6];
  if (result.name.back() == '_' || result.name.find("__") != std::string::npos)
    throw std::runtime_error("bad name: " + line);
  const auto primitive = kTypeIds.find(part[2]);
  if (primitive != kTypeIds.end() && !part[1].matched) {
    result.type_id = part[3].matched ? 21 : primitive->second;
    if (part[3].matched) result.string_capacity = std::stoull(part[3]);
  } else {
    result.type_id = 1;
    result.nested = (part[1].matched ? part[1].str() : package) + "/msg/" + part[2].str();
  }
  if (part[5].matched) {
    if (part[5].length() != 0) result.capacity = std::stoull(part[5]);
    result.type_id += result.capacity == 0 ? 144 : part[4].matched ? 96 : 48;
  }
  fields.push_back(std::move(result));
}

/// The parts of a file, between its lines `---`.
std::vector<Fields> parse(const std::string& package, const std::string& text) {
  std::vector<Fields> parts(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "---") {
      parts.emplace_back();
    } else {
      parse_line(line.substr(0, line.find('#')), package, parts.back());
    }
  }
  for (Fields& fields : parts) {
    if (fields.empty()) fields.push_back({"structure_needs_at_least_one_member", 3, 0, 0, ""});
  }
  return parts;
}

std::string described(const std::string& name, const Fields& fields) {
  std::ostringstream out;
  out << R"({"type_name": ")" << name << R"(", "fields": [)";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const TextField& f = fields[i];
    out << (i == 0 ? "" : ", ") << R"({"name": ")" << f.name << R"(", "type": {"type_id": )" << f.type_id
        << R"(, "capacity": )" << f.capacity << R"(, "string_capacity": )" << f.string_capacity
        << R"(, "nested_type_name": ")" << f.nested << R"("}})";
  }
  out << "]}";
  return out.str();
}

std::string sha256(const std::string& text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  std::string hex;
  for (const unsigned char byte : digest) {
    std::array<char, 3> two{};
    std::snprintf(two.data(), two.size(), "%02x", byte);
    hex += two.data();
  }
  return hex;
}

}  // namespace

void InterfaceTexts::read(const std::string& package, const std::string& category, const std::string& name,
                          const std::string& text) {
  if (!std::regex_match(name, std::regex("[A-Z][A-Za-z0-9]*")))
    throw std::runtime_error("bad type name: " + name);
  const std::string full = package + "/" + category + "/" + name;
  const std::vector<Fields> parts = parse(package, text);
  const std::map<std::string, std::size_t> expected = {{"msg", 1}, {"srv", 2}, {"action", 3}};
  if (parts.size() != expected.at(category)) throw std::runtime_error("wrong number of parts: " + full);
  const auto service = [&](const std::string& of, const Fields& request, const Fields& response) {
    types_[of + "_Request"] = request;
    types_[of + "_Response"] = response;
    types_[of + "_Event"] = {field("info", "service_msgs/msg/ServiceEventInfo"),
                             field("request", of + "_Request", 1), field("response", of + "_Response", 1)};
  };
  if (category == "msg") types_[full] = parts[0];
  if (category == "srv") service(full, parts[0], parts[1]);
  if (category == "action") {
    const TextField goal_id = field("goal_id", "unique_identifier_msgs/msg/UUID");
    types_[full + "_Goal"] = parts[0];
    types_[full + "_Result"] = parts[1];
    types_[full + "_Feedback"] = parts[2];
    service(full + "_SendGoal", {goal_id, field("goal", full + "_Goal")},
            {{"accepted", 15, 0, 0, ""}, field("stamp", "builtin_interfaces/msg/Time")});
    service(full + "_GetResult", {goal_id}, {{"status", 2, 0, 0, ""}, field("result", full + "_Result")});
    types_[full + "_FeedbackMessage"] = {goal_id, field("feedback", full + "_Feedback")};
  }
}

std::map<std::string, std::string> InterfaceTexts::hashes() const {
  std::map<std::string, std::string> result;
  for (const auto& [name, fields] : types_) {
    std::set<std::string> reached;
    std::vector<std::string> open = {name};
    while (!open.empty()) {
      const Fields& of = types_.at(open.back());
      open.pop_back();
      for (const TextField& f : of) {
        if (!f.nested.empty() && reached.insert(f.nested).second) open.push_back(f.nested);
      }
    }
    std::string referenced;
    for (const std::string& other : reached)
      referenced += (referenced.empty() ? "" : ", ") + described(other, types_.at(other));
    result[name] = "RIHS01_" + sha256(R"({"type_description": )" + described(name, fields) +
                                      R"(, "referenced_type_descriptions": [)" + referenced + "]}");
  }
  return result;
}

}  // namespace bw::test
