#include "runtime/remote/web/request.hpp"

#include <algorithm>

#include <strings.h>

namespace bw::web {
namespace {

bool is_same_name(std::string_view a, std::string_view b) {
  return a.size() == b.size() && strncasecmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace

std::optional<std::string_view> Request::find(std::string_view name) const {
  for (const auto& [key, value] : headers) {
    if (is_same_name(key, name)) return value;
  }
  return std::nullopt;
}

std::size_t Request::count(std::string_view name) const {
  return static_cast<std::size_t>(std::count_if(
      headers.begin(), headers.end(), [&](const auto& header) { return is_same_name(header.first, name); }));
}

std::uint64_t Reply::size() const {
  if (const auto* text = std::get_if<std::string>(&body)) return text->size();
  if (const auto* bytes = std::get_if<std::span<const std::uint8_t>>(&body)) return bytes->size();
  const auto& part = std::get<FilePart>(body);
  return part.end - part.begin;
}

Reply plain_reply(int status, std::string_view reason) {
  return {status,
          {{"Content-Type", "text/plain; charset=utf-8"}, {"Cache-Control", "no-store"}},
          std::string(reason) + '\n'};
}

}  // namespace bw::web
