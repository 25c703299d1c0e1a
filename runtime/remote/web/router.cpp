#include "runtime/remote/web/router.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/remote/web/byte_range.hpp"
#include "runtime/remote/web/content_coding.hpp"

namespace bw::web {
namespace {

constexpr std::string_view kTokenInUrl =
    "this token does not belong into a URL, where logs keep it: use the login at / or Authorization: Bearer";

/// One for all servers of a process, so that a server that is started again takes it.
const std::string& token_of_run() {
  static const std::string token = random_text();
  return token;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

Reply not_allowed(std::string_view methods) {
  Reply reply = plain_reply(405, fmt::format("this is for {}", methods));
  reply.headers.emplace_back("Allow", methods);
  return reply;
}

/// For a page of elsewhere that is let in (CORS): Foxglove opens a recording by its address.
Reply readable_from(std::string_view origin, Reply reply) {
  reply.headers.emplace_back("Access-Control-Allow-Origin", origin);
  reply.headers.emplace_back("Access-Control-Expose-Headers", "Accept-Ranges, Content-Range, ETag");
  return reply;
}

Reply preflight_reply() {
  return {204,
          {{"Access-Control-Allow-Methods", "GET, HEAD"},
           {"Access-Control-Allow-Headers", "Range, If-Range, If-None-Match"},
           {"Access-Control-Allow-Private-Network", "true"},
           {"Cache-Control", "no-store"}},
          std::string()};
}

bool is_reading(const Request& request) { return request.method == "GET" || request.method == "HEAD"; }

bool has_tag(std::string_view list, std::string_view etag) {
  while (!list.empty()) {
    const std::string_view item = list.substr(0, list.find(','));
    list.remove_prefix(std::min(list.size(), item.size() + 1));
    std::string_view one = trimmed(item);
    if (one.starts_with("W/")) one.remove_prefix(2);
    if (one == etag || one == "*") return true;
  }
  return false;
}

AccessRules rules_of(const ServerOptions& options, bool is_loopback) {
  return {.is_loopback = is_loopback,
          .is_reading_free = is_loopback && options.token_file.empty(),
          .host_names = options.host_names,
          .allow_origins = options.allow_origins,
          .allow_commands = options.allow_commands};
}

std::string token_of_options(const ServerOptions& options) {
  return options.token_file.empty() ? token_of_run() : read_token_file(options.token_file);
}

}  // namespace

Router::Router(const ServerOptions& options, bool is_loopback, Site site,
               std::vector<std::string> subprotocols)
    : gate_(rules_of(options, is_loopback), token_of_options(options),
            static_cast<std::size_t>(options.limits.login_attempts)),
      site_(std::move(site)),
      bags_(options.bag_folder.empty() ? nullptr : std::make_unique<BagFolder>(options.bag_folder)),
      subprotocols_(std::move(subprotocols)),
      handshakes_(options.limits.handshakes_per_second,
                  std::max(1.0, 2 * options.limits.handshakes_per_second)) {}

std::string Router::run_token() const { return gate_.is_reading_free() ? token_of_run() : std::string(); }

Reply Router::answer(const Request& request) {
  if (auto refusal = gate_.refuse_caller(request)) return *refusal;
  const auto parsed = parse_target(request.target);
  if (const auto* reason = std::get_if<std::string>(&parsed)) return plain_reply(400, *reason);
  const auto& target = std::get<RequestTarget>(parsed);
  if (target.token && !gate_.is_reading_free()) return plain_reply(400, kTokenInUrl);
  if (request.method == "POST" && target.path == "/login") return gate_.log_in(request);
  if (auto refusal = gate_.refuse_reading(request)) return *refusal;
  const Caller caller = caller_of(request);
  if (!caller.origin || is_own_page(caller)) return answer_let_in(request, target);
  const bool is_preflight =
      request.method == "OPTIONS" && !request.get("Access-Control-Request-Method").empty();
  return readable_from(*caller.origin, is_preflight ? preflight_reply() : answer_let_in(request, target));
}

Reply Router::answer_let_in(const Request& request, const RequestTarget& target) {
  if (target.path == "/login" || target.path == "/logout") {
    if (request.method != "POST") return not_allowed("POST");
    return gate_.log_out(request);
  }
  if (target.segments.front() == "bags" && target.segments.size() > 1) return bag_reply(request, target);
  return site_reply(request, target);
}

Reply Router::site_reply(const Request& request, const RequestTarget& target) const {
  const auto file = std::find_if(site_.files.begin(), site_.files.end(),
                                 [&](const SiteFile& f) { return f.path == target.path; });
  if (file == site_.files.end()) {
    if (target.path != "/" || !site_.files.empty()) return plain_reply(404, "there is no such page");
    if (!is_reading(request)) return not_allowed("GET, HEAD");
    return plain_reply(
        200,
        "This program was built without its page (Node.js was not there); Foxglove and Lichtblick "
        "can connect to this address.");
  }
  if (!is_reading(request)) return not_allowed("GET, HEAD");
  const bool as_gzip = accepts_gzip(request.get("Accept-Encoding"));
  std::string etag(file->etag);
  if (!as_gzip && etag.size() > 1) etag.insert(etag.size() - 1, "-plain");
  Reply reply{200,
              {{"Content-Type", std::string(file->content_type)},
               {"Cache-Control", "private, no-cache"},
               {"ETag", etag},
               {"Vary", "Accept-Encoding"},
               {"Content-Security-Policy", site_.content_security_policy}},
              std::string()};
  if (has_tag(request.get("If-None-Match"), etag)) {
    reply.status = 304;
  } else if (as_gzip) {
    reply.headers.emplace_back("Content-Encoding", "gzip");
    reply.body = file->gzip;
  } else {
    reply.body = inflated(file->gzip);
  }
  return reply;
}

Reply Router::bag_reply(const Request& request, const RequestTarget& target) const {
  if (!is_reading(request)) return not_allowed("GET, HEAD");
  if (target.path == "/bags/") {
    // Without a folder there are none: the page asks each time, and a browser would print a refusal as an
    // error.
    return {200,
            {{"Content-Type", "application/json"}, {"Cache-Control", "no-store"}},
            bags_ ? bags_->list() : std::string("[]")};
  }
  if (!bags_) return plain_reply(404, "no folder of bags is served");
  const auto opened = bags_->open({target.segments.begin() + 1, target.segments.end()});
  if (const auto* refusal = std::get_if<FileRefusal>(&opened)) {
    return plain_reply(refusal->status, refusal->reason);
  }
  const auto& file = std::get<std::shared_ptr<const ServedFile>>(opened);
  Reply reply{200,
              {{"Content-Type", "application/octet-stream"},
               {"Cache-Control", "private, no-cache"},
               {"ETag", file->etag()},
               {"Accept-Ranges", "bytes"}},
              FilePart{file, 0, file->size()}};
  if (has_tag(request.get("If-None-Match"), file->etag())) {
    reply.status = 304;
    reply.body = std::string();
    return reply;
  }
  const auto condition = request.find("If-Range");
  if (condition && *condition != file->etag()) return reply;
  const ByteRange range = parse_range(request.get("Range"), file->size());
  if (range.kind == ByteRange::Kind::unsatisfiable) {
    reply = plain_reply(416, "the file does not reach that far");
    reply.headers.emplace_back("Content-Range", fmt::format("bytes */{}", file->size()));
  } else if (range.kind == ByteRange::Kind::part) {
    reply.status = 206;
    reply.headers.emplace_back("Content-Range",
                               fmt::format("bytes {}-{}/{}", range.begin, range.end - 1, file->size()));
    reply.body = FilePart{file, range.begin, range.end};
  }
  return reply;
}

std::string Router::agreed_subprotocol(const Request& request) const {
  std::vector<std::string_view> offered;
  for (const auto& [name, value] : request.headers) {
    if (name != "Sec-WebSocket-Protocol") continue;
    std::string_view rest = value;
    while (!rest.empty()) {
      const std::string_view one = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), one.size() + 1));
      offered.push_back(trimmed(one));
    }
  }
  for (const std::string& ours : subprotocols_) {
    if (std::find(offered.begin(), offered.end(), ours) != offered.end()) return ours;
  }
  return {};
}

std::variant<Admission, Reply> Router::admit(const Request& request) {
  if (auto refusal = gate_.refuse_caller(request)) return *refusal;
  const auto parsed = parse_target(request.target);
  if (const auto* reason = std::get_if<std::string>(&parsed)) return plain_reply(400, *reason);
  const auto& target = std::get<RequestTarget>(parsed);
  if (target.token && !gate_.is_loopback()) return plain_reply(400, kTokenInUrl);
  if (auto refusal = gate_.refuse_reading(request, target.token)) return *refusal;
  if (target.path != "/") return plain_reply(404, "sockets are opened at /");
  const std::string agreed = agreed_subprotocol(request);
  if (agreed.empty()) {
    return plain_reply(
        400, fmt::format("Sec-WebSocket-Protocol has to offer one of: {}", fmt::join(subprotocols_, ", ")));
  }
  if (!handshakes_.take(request.now)) {
    Reply reply = plain_reply(503, "too many sockets are opened: try again in a second");
    reply.headers.emplace_back("Retry-After", "1");
    return reply;
  }
  return Admission{agreed, std::string(request.get("Origin")), gate_.read_only(request, target.token)};
}

}  // namespace bw::web
