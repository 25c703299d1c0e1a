// Which topics of a running system are recorded.
#pragma once

#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace bw::record {

struct TopicChoiceOptions {
  std::vector<std::string> topics;                   ///< by name; a missing / in front is added
  bool all = false;                                  ///< every topic but hidden ones
  bool hidden = false;                               ///< those with a token that begins with _ as well
  std::optional<std::regex> exclude = std::nullopt;  ///< searched in names; not for topics that are named
  std::vector<std::string> nodes;  ///< what these nodes write or read; a missing / in front is added
};

class TopicChoice {
 public:
  /// Throws std::runtime_error when nothing is chosen, the choices contradict each other or a name is none.
  explicit TopicChoice(const TopicChoiceOptions& options);

  /// `nodes`: full names of all that write or read the topic.
  [[nodiscard]] bool wants(const std::string& topic, const std::set<std::string>& nodes) const;

 private:
  std::set<std::string> topics_;
  std::set<std::string> nodes_;
  std::optional<std::regex> exclude_;
  bool all_;
  bool hidden_;
};

}  // namespace bw::record
