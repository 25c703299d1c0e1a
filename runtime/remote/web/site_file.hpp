// A page and what it consists of, as values: packed into the program when it was built.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bw::web {

/// What it refers to lives as long as the server.
struct SiteFile {
  std::string_view path;               ///< /, /app.js
  std::string_view content_type;       ///< text/html; charset=utf-8
  std::span<const std::uint8_t> gzip;  ///< the file, compressed
  std::string_view etag;               ///< of these bytes, with its quotes
};

struct Site {
  std::vector<SiteFile> files;  ///< none: `/` says in a sentence that this program has no page
  /// What the page may load: itself and nothing else. `blob:` is for workers and pictures that it makes.
  std::string content_security_policy =
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
      "connect-src 'self'; worker-src 'self' blob:; base-uri 'none'; form-action 'self'; frame-ancestors 'none'";
};

}  // namespace bw::web
