#include "idl/compiler/derive.hpp"

#include <algorithm>
#include <stdexcept>

#include "idl/compiler/names.hpp"

namespace bw::idl {
namespace {

Member single(std::string name, Kind kind) {
  Member member;
  member.name = std::move(name);
  member.kind = kind;
  return member;
}

Member single(std::string name, std::string message) {
  Member member = single(std::move(name), Kind::kMessage);
  member.message = std::move(message);
  return member;
}

Member at_most_one(std::string name, std::string message) {
  Member member = single(std::move(name), std::move(message));
  member.shape = Shape::kSequence;
  member.capacity = 1;
  return member;
}

const char* const kTime = "builtin_interfaces/msg/Time";
const char* const kUuid = "unique_identifier_msgs/msg/UUID";
const char* const kEventInfo = "service_msgs/msg/ServiceEventInfo";

class Deriver {
 public:
  explicit Deriver(File& file) : file_(file), interface_(interface_of(file.path)) {}

  void run() {
    if (interface_.category == "msg") {
      check({""});
    } else if (interface_.category == "srv") {
      check({"_Request", "_Response"});
      add_event("");
    } else if (interface_.category == "action") {
      check({"_Goal", "_Result", "_Feedback"});
      const Member goal_id = single("goal_id", use(kUuid));
      add("_SendGoal_Request", {goal_id, single("goal", type("_Goal"))});
      add("_SendGoal_Response", {single("accepted", Kind::kBoolean), single("stamp", use(kTime))});
      add_event("_SendGoal");
      add("_GetResult_Request", {goal_id});
      add("_GetResult_Response", {single("status", Kind::kInt8), single("result", type("_Result"))});
      add_event("_GetResult");
      add("_FeedbackMessage", {goal_id, single("feedback", type("_Feedback"))});
    }
  }

 private:
  [[noreturn]] void fail(int line, const std::string& what) const {
    throw std::runtime_error(file_.path + ":" + std::to_string(line) + ": " + what);
  }

  void check(const std::vector<std::string>& suffixes) const {
    if (!is_type_name(interface_.name)) fail(1, "expected a file's name in CamelCase");
    for (std::size_t i = 0; i < std::max(suffixes.size(), file_.structs.size()); ++i) {
      const std::string expected =
          i < suffixes.size() ? "struct " + cpp_name(suffixes[i]) : "no more structs";
      if (i == file_.structs.size())
        fail(file_.lines, "expected " + expected + ", found the end of the file");
      const Struct& found = file_.structs[i];
      if ("struct " + found.cpp_name() != expected)
        fail(found.line, "expected " + expected + ", found " + found.cpp_name());
    }
    for (const Constants& constants : file_.constants) {
      const auto named = [&](const std::string& suffix) {
        return constants.name == interface_.name + suffix + "_Constants";
      };
      if (std::none_of(suffixes.begin(), suffixes.end(), named))
        fail(constants.line, constants.name + " belongs to no struct of this file");
    }
  }

  [[nodiscard]] std::string cpp_name(const std::string& suffix) const {
    return interface_.cpp_name() + suffix;
  }
  [[nodiscard]] std::string type(const std::string& suffix) const { return interface_.ros_name() + suffix; }

  void add(const std::string& suffix, std::vector<Member> members) {
    file_.structs.push_back(
        {{interface_.package, interface_.category, interface_.name + suffix, interface_.distro},
         std::move(members)});
  }

  void add_event(const std::string& service) {
    add(service + "_Event",
        {single("info", use(kEventInfo)), at_most_one("request", type(service + "_Request")),
         at_most_one("response", type(service + "_Response"))});
  }

  /// Its file is included from now on.
  std::string use(const std::string& message) {
    const std::string path = message + ".idl";
    if (std::find(file_.includes.begin(), file_.includes.end(), path) == file_.includes.end())
      file_.includes.push_back(path);
    return message;
  }

  File& file_;
  Interface interface_;
};

}  // namespace

void derive(File& file) { Deriver(file).run(); }

}  // namespace bw::idl
