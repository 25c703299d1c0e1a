#include "components/robot_base/link_guard.hpp"

#include <algorithm>

namespace bw {

void LinkGuard::read(Time now, const LinkState& link, bool has_counts) {
  link_ = link;
  if (has_counts && link.is_open) heard_ = now;
}

void LinkGuard::told(Time now, bool is_through) {
  // Before it was ever heard there may be no open port to take them: that is no base that was lost.
  if (is_through || !heard_)
    refused_since_.reset();
  else
    refused_since_ = std::min(refused_since_.value_or(now), now);
}

bool LinkGuard::is_beginning(Time now) {
  first_look_ = std::min(first_look_.value_or(now), now);
  return now - *first_look_ < Duration::milliseconds(1000);
}

LinkHealth LinkGuard::judge(Time now) {
  const std::string name = link_.device.empty() ? "the base" : link_.device;
  if (!link_.is_open) {
    reason_ = name + " is not connected" + (link_.fault.empty() ? "" : ": " + link_.fault);
    return heard_ ? LinkHealth::lost : LinkHealth::unheard;
  }
  const bool is_anew = heard_ && openings_ != 0 && link_.openings != openings_;
  openings_ = link_.openings;
  if (is_anew) {
    reason_ = name + " was opened anew";
    return LinkHealth::reopened;
  }
  if (!heard_) {
    reason_ = name + " has not told its wheels yet";
    return LinkHealth::unheard;
  }
  heard_ = std::min(*heard_, now);  // the clock went back
  if (refused_since_ && now - *refused_since_ >= silence_) {
    reason_ = "commands do not get through to " + name;
    return LinkHealth::lost;
  }
  if (now - *heard_ >= silence_) {
    reason_ = name + " is silent";
    return LinkHealth::lost;
  }
  reason_.clear();
  return LinkHealth::heard;
}

}  // namespace bw
