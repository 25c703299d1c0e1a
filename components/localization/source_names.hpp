// Sources by name: a filter knows them by number, people by name. A source of a name of its own is all that a
// further sensor needs.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bw::localization {

class SourceNames {
 public:
  /// The number of a new source.
  int add(std::string name) {
    names_.push_back(std::move(name));
    return count() - 1;
  }
  int count() const { return static_cast<int>(names_.size()); }
  std::string of(int source) const {
    return source >= 0 && source < count() ? names_[static_cast<std::size_t>(source)] : "unknown";
  }

 private:
  std::vector<std::string> names_;
};

}  // namespace bw::localization
