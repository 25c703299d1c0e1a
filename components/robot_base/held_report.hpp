// What was wrong at an instant, told for as long as a person or a slower program needs to see it.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "runtime/base/time.hpp"

namespace bw {

class HeldReport {
 public:
  explicit HeldReport(Duration time = Duration::milliseconds(1000)) : time_(time) {}

  /// `text` is for people. Of one kind the first text stays for as long as it is told, so that what goes on
  /// is one news.
  void say(Time now, const std::string& kind, std::string text) {
    const auto [one, is_new] = said_.try_emplace(kind, now, std::move(text));
    one->second.first = now;
  }
  void clear() { said_.clear(); }

  /// All that is still told, one after the other; empty: nothing. A clock that went back makes nothing older.
  std::string text(Time now) {
    std::string all;
    for (auto one = said_.begin(); one != said_.end();) {
      auto& [at, text] = one->second;
      if (now < at) at = now;
      if (now - at > time_) {
        one = said_.erase(one);
        continue;
      }
      all += (all.empty() ? "" : "; ") + text;
      ++one;
    }
    return all;
  }

 private:
  Duration time_;
  std::map<std::string, std::pair<Time, std::string>> said_;
};

}  // namespace bw
