// A request and its answer as values, so that what is answered is decided without sockets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/remote/web/bag_folder.hpp"

namespace bw::web {

struct Request {
  std::string method;  ///< GET
  std::string target;  ///< as it came
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  std::string address;  ///< of the client, without its port
  double now = 0;       ///< of a steady clock [s]

  /// The first of that name in any case; nothing where there is none.
  std::optional<std::string_view> find(std::string_view name) const;
  std::string_view get(std::string_view name) const { return find(name).value_or(std::string_view{}); }
  std::size_t count(std::string_view name) const;
};

/// Bytes [begin, end) of a file.
struct FilePart {
  std::shared_ptr<const ServedFile> file;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

struct Reply {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::variant<std::string, std::span<const std::uint8_t>, FilePart> body;

  std::uint64_t size() const;
};

/// A reason as plain text.
Reply plain_reply(int status, std::string_view reason);

}  // namespace bw::web
