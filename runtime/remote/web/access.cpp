#include "runtime/remote/web/access.hpp"

#include <algorithm>
#include <cctype>

#include <arpa/inet.h>

namespace bw::web {
namespace {

/// The name of NAME, NAME:PORT, [V6] or [V6]:PORT in small letters; nothing where it is none of them.
std::optional<std::string> name_of(std::string_view authority) {
  std::size_t end = authority.find(':');
  if (authority.starts_with('[')) {
    end = authority.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    ++end;
  }
  const std::string_view name = authority.substr(0, end);
  std::string_view port = authority.substr(name.size());
  if (!port.empty()) {
    port.remove_prefix(1);
    if (authority[name.size()] != ':' || port.empty() || port.size() > 5) return std::nullopt;
    if (port.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  }
  if (name.empty() || name.find_first_of("@/\\ ") != std::string_view::npos) return std::nullopt;
  std::string small(name);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

std::optional<in_addr> v4(const std::string& name) {
  in_addr address{};
  return inet_pton(AF_INET, name.c_str(), &address) == 1 ? std::optional(address) : std::nullopt;
}

std::optional<in6_addr> v6(const std::string& name) {
  if (name.size() < 2 || name.front() != '[' || name.back() != ']') return std::nullopt;
  in6_addr address{};
  return inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), &address) == 1 ? std::optional(address)
                                                                                     : std::nullopt;
}

bool is_address(const std::string& name) { return v4(name) || v6(name); }

bool is_loopback_name(const std::string& name) {
  if (name == "localhost") return true;
  if (const auto address = v4(name)) return ntohl(address->s_addr) >> 24 == 127;
  const auto address = v6(name);
  return address && IN6_IS_ADDR_LOOPBACK(&*address);
}

/// The authority of http://AUTHORITY or https://AUTHORITY.
std::optional<std::string_view> authority_of(std::string_view origin) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return origin.substr(scheme.size());
  }
  return std::nullopt;
}

std::string printable(std::string_view text) {
  std::string out(text.substr(0, 100));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return out;
}

bool contains(const std::vector<std::string>& texts, std::string_view text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace

std::optional<std::string> refused_host(const AccessRules& rules, const Caller& caller) {
  if (!caller.host) return "a request needs one header Host";
  const auto name = name_of(*caller.host);
  if (!name) return "Host is not NAME or NAME:PORT";
  if (is_loopback_name(*name)) return std::nullopt;
  if (rules.is_loopback) return "Host is not this machine: 127.0.0.1, localhost and [::1] are";
  if (is_address(*name) || contains(rules.host_names, *name)) return std::nullopt;
  return "Host is not a name of this machine: its addresses and host_names are";
}

std::optional<std::string> refused_origin(const AccessRules& rules, const Caller& caller) {
  if (!caller.origin) {
    if (caller.fetch_site == "cross-site" && caller.fetch_mode != "navigate") {
      return "pages of elsewhere may not use this server";
    }
    return std::nullopt;
  }
  if (contains(rules.allow_origins, *caller.origin) || is_own_page(caller)) return std::nullopt;
  const auto authority = authority_of(*caller.origin);
  const auto name = authority ? name_of(*authority) : std::nullopt;
  if (name && is_loopback_name(*name)) return std::nullopt;
  return "Origin `" + printable(*caller.origin) +
         "` is not allowed: --allow-origin names exactly the origins that are";
}

bool is_own_page(const Caller& caller) {
  if (!caller.origin || !caller.host) return false;
  const auto authority = authority_of(*caller.origin);
  return authority && *authority == *caller.host && name_of(*authority);
}

}  // namespace bw::web
