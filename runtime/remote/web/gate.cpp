#include "runtime/remote/web/gate.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "runtime/remote/web/request_target.hpp"

namespace bw::web {
namespace {

constexpr std::string_view kLoginPage =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>bandwagon</title>"
    "<form method=\"post\" action=\"/login\"><p><label>Token <input name=\"token\" type=\"password\" "
    "autocomplete=\"current-password\" autofocus></label> <button>Open</button></form></html>\n";

constexpr const char* kLooksOn = "from other machines commands need --allow-commands";
constexpr const char* kNoToken =
    "commands need the token of this run: open the address with ?token= that the program printed";
constexpr const char* kWrongToken =
    "the token is not that of this run: open the address with ?token= that the program printed";

/// A header goes before the query.
std::optional<std::string> given_token(const Request& request,
                                       const std::optional<std::string>& query_token) {
  if (const auto authorization = request.find("Authorization")) return token_of(*authorization).value_or("");
  return query_token;
}

Reply login_page() {
  return {401,
          {{"Content-Type", "text/html; charset=utf-8"},
           {"Cache-Control", "no-store"},
           {"WWW-Authenticate", "Bearer"},
           {"Content-Security-Policy",
            "default-src 'none'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'"}},
          std::string(kLoginPage)};
}

Reply unauthorized(std::string_view reason) {
  Reply reply = plain_reply(401, reason);
  reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  return reply;
}

/// To the page, with its cookie.
Reply back_to_page(const std::string& cookie) {
  return {303, {{"Location", "/"}, {"Cache-Control", "no-store"}, {"Set-Cookie", cookie}}, std::string()};
}

}  // namespace

Caller caller_of(const Request& request) {
  return {.host = request.find("Host"),
          .origin = request.find("Origin"),
          .fetch_site = request.get("Sec-Fetch-Site"),
          .fetch_mode = request.get("Sec-Fetch-Mode")};
}

Gate::Gate(AccessRules rules, std::string token, std::size_t login_attempts)
    : rules_(std::move(rules)), token_(std::move(token)), attempts_(login_attempts) {}

std::optional<Reply> Gate::refuse_caller(const Request& request) const {
  if (request.count("Host") != 1) return plain_reply(400, "a request has one header Host");
  if (request.count("Origin") > 1) return plain_reply(400, "a request has one header Origin at most");
  const Caller caller = caller_of(request);
  if (const auto reason = refused_host(rules_, caller)) return plain_reply(403, *reason);
  if (const auto reason = refused_origin(rules_, caller)) return plain_reply(403, *reason);
  return std::nullopt;
}

std::optional<Reply> Gate::refuse_reading(const Request& request,
                                          const std::optional<std::string>& query_token) {
  if (rules_.is_reading_free) return std::nullopt;
  if (const auto given = given_token(request, query_token)) return judge(*given, request);
  // To a browser all ports of a machine are one site: it sends the cookie for pages of other ports too.
  const Caller caller = caller_of(request);
  const bool is_own = !caller.origin || is_own_page(caller);
  if (is_own && sessions_.holds(cookie_of(request), request.address, request.now)) return std::nullopt;
  if (request.method == "GET" && request.target == "/" && !request.find("Upgrade")) return login_page();
  return unauthorized("a token is needed: Authorization: Bearer TOKEN, or a browser's login at /");
}

std::optional<Reply> Gate::judge(const std::string& given, const Request& request) {
  if (!attempts_.may_try(request.address, request.now)) {
    return plain_reply(429, "too many wrong tokens: wait a minute");
  }
  if (is_equal_in_constant_time(given, token_)) return std::nullopt;
  attempts_.count_failure(request.address, request.now);
  return unauthorized("the token is wrong");
}

std::string Gate::read_only(const Request& request, const std::optional<std::string>& query_token) const {
  if (!rules_.is_loopback) return rules_.allow_commands ? "" : kLooksOn;
  if (!rules_.is_reading_free) return {};  // the token has been shown
  const auto given = given_token(request, query_token);
  if (!given) return kNoToken;
  return is_equal_in_constant_time(*given, token_) ? "" : kWrongToken;
}

std::string Gate::cookie_of(const Request& request) const {
  std::string_view rest = request.get("Cookie");
  while (!rest.empty()) {
    std::string_view pair = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    pair.remove_prefix(std::min(pair.size(), pair.find_first_not_of(' ')));
    if (pair.starts_with(cookie_ + '=')) return std::string(pair.substr(cookie_.size() + 1));
  }
  return {};
}

Reply Gate::log_in(const Request& request) {
  if (rules_.is_reading_free) return plain_reply(404, "no token is needed here");
  if (!is_own_page(caller_of(request))) return plain_reply(403, "only the server's own page logs in");
  if (auto refusal = judge(form_field(request.body, "token"), request)) return *refusal;
  return back_to_page(cookie_ + '=' + sessions_.open(request.address, request.now) +
                      "; Path=/; HttpOnly; SameSite=Strict");
}

Reply Gate::log_out(const Request& request) {
  if (!is_own_page(caller_of(request))) return plain_reply(403, "only the server's own page logs out");
  sessions_.close(cookie_of(request));
  return back_to_page(cookie_ + "=; Path=/; HttpOnly; SameSite=Strict; Max-Age=0");
}

}  // namespace bw::web
