#include "runtime/ros/dds_names.hpp"

#include <string_view>

namespace bw {
namespace {

constexpr std::string_view kPrefix = "rt";
constexpr std::string_view kRequest = "Request";
constexpr std::string_view kMarker = "::dds_::";
constexpr std::string_view kHashKey = "typehash=";

}  // namespace

std::string ros_topic(const std::string& dds_topic) {
  return dds_topic.starts_with("rt/") ? dds_topic.substr(kPrefix.size()) : dds_topic;
}

std::string dds_topic(const std::string& ros_topic) { return std::string(kPrefix) + ros_topic; }

std::string request_topic(const std::string& service) { return "rq" + service + std::string(kRequest); }

std::string reply_topic(const std::string& service) { return "rr" + service + "Reply"; }

std::string service_of_request(const std::string& dds_topic) {
  if (!dds_topic.starts_with("rq/") || !dds_topic.ends_with(kRequest)) return {};
  return dds_topic.substr(2, dds_topic.size() - 2 - kRequest.size());
}

std::string ros_type(const std::string& dds_type) {
  const std::size_t marker = dds_type.find(kMarker);
  if (marker == std::string::npos || !dds_type.ends_with('_')) return dds_type;
  const std::size_t name_at = marker + kMarker.size();
  std::string name =
      dds_type.substr(0, marker) + "/" + dds_type.substr(name_at, dds_type.size() - name_at - 1);
  for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::"))
    name.replace(at, 2, "/");
  return name;
}

std::string dds_type(const std::string& ros_type) {
  const std::size_t first = ros_type.find('/');
  const std::size_t last = ros_type.rfind('/');
  if (first == std::string::npos || first == last) return ros_type;
  return ros_type.substr(0, first) + "::" + ros_type.substr(first + 1, last - first - 1) +
         std::string(kMarker) + ros_type.substr(last + 1) + "_";
}

std::string type_hash_in(const std::string& user_data) {
  const std::size_t at = user_data.find(kHashKey);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + kHashKey.size();
  const std::size_t end = user_data.find(';', begin);
  return user_data.substr(begin, end == std::string::npos ? end : end - begin);
}

std::string user_data_of(const std::string& type_hash) {
  return type_hash.empty() ? "" : std::string(kHashKey) + type_hash + ";";
}

}  // namespace bw
