// Who may speak with the server: the rules about Host and Origin. Pure.
//
// A page of elsewhere in the same browser can send requests to 127.0.0.1. Its Origin tells it, so only pages
// of this machine and those that were named are heard. A page whose name was made to mean 127.0.0.1 (DNS
// rebinding) has no foreign Origin for the browser; its Host tells it, so the server answers only to names
// that are its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw::web {

struct AccessRules {
  bool is_loopback = true;      ///< the address listened on can be reached from this machine only
  bool is_reading_free = true;  ///< who shows no token may read: on a loopback address without a token_file
  std::vector<std::string>
      host_names;  ///< names of this machine, beside addresses; used where not is_loopback
  std::vector<std::string> allow_origins;  ///< exactly as a browser writes them: https://app.foxglove.dev
  bool allow_commands = false;             ///< used where not is_loopback
};

/// What of a request counts here. Nothing: the header is not there.
struct Caller {
  std::optional<std::string_view> host;
  std::optional<std::string_view> origin;
  std::string_view fetch_site;  ///< Sec-Fetch-Site, where a browser says so
  std::string_view fetch_mode;  ///< Sec-Fetch-Mode
};

/// The reason, or nothing. Loopback: Host has to be localhost, 127.x.y.z or [::1]; otherwise any address or
/// one of host_names; with any port.
std::optional<std::string> refused_host(const AccessRules& rules, const Caller& caller);

/// The reason, or nothing. Allowed: no Origin (programs, and a browser that goes to a page), the server's own
/// page, pages of this machine at any port, and allow_origins. A browser that fetches for a page of elsewhere
/// without an Origin (pictures, scripts) is refused.
std::optional<std::string> refused_origin(const AccessRules& rules, const Caller& caller);

/// Of a page that the server itself delivered. Needed for what changes something by a plain request.
bool is_own_page(const Caller& caller);

}  // namespace bw::web
