// How a bag is to be written, as the command line says it: shared by all verbs that record.
#pragma once

#include <string>
#include <string_view>

#include "runtime/cli/verb.hpp"
#include "runtime/recording/bag/bag_writer.hpp"

namespace bw::cli {

struct BagWriting {
  static constexpr std::string_view kOptions[] = {"--split-size", "--split-duration", "--max-size",
                                                  "--compression"};

  std::string split_size;
  std::string split_duration;
  std::string max_size;
  std::string compression = "zstd";

  void add_to(Verb verb);
  [[nodiscard]] bool splits() const {
    return !split_size.empty() || !split_duration.empty() || !max_size.empty();
  }
  /// For a bag at `path`. Throws std::runtime_error naming option, value and rule.
  [[nodiscard]] bag::BagWriterOptions options(const std::string& path) const;
};

/// "100MB" in bytes; 0 for an empty text. Throws std::runtime_error naming option, value and rule.
[[nodiscard]] std::uint64_t size_option(const std::string& option, const std::string& text,
                                        std::uint64_t least);

/// "30s"; zero for an empty text, at least a second else. Throws as size_option.
[[nodiscard]] Duration duration_option(const std::string& option, const std::string& text);

}  // namespace bw::cli
