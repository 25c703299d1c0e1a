#include "runtime/cli/bag_writing.hpp"

#include <filesystem>
#include <optional>
#include <stdexcept>

#include "runtime/parameters/scalar_text.hpp"

namespace bw::cli {
namespace {

constexpr Duration kShortest = Duration::milliseconds(1000);

[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& rule) {
  throw std::runtime_error(option + " " + value + ": " + rule);
}

}  // namespace

std::uint64_t size_option(const std::string& option, const std::string& text, std::uint64_t least) {
  if (text.empty()) return 0;
  const std::optional<std::uint64_t> size = parse_size(text);
  if (!size || *size < least)
    refuse(option, text,
           "must be a size of at least " + std::to_string(least / 1'000'000) + "MB, such as 100MB or 2GiB");
  return *size;
}

Duration duration_option(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  const std::optional<Duration> duration = parse_duration(text);
  if (!duration || *duration < kShortest)
    refuse(option, text, "must be a duration of at least 1 s, such as 30s or 10min");
  return *duration;
}

void BagWriting::add_to(Verb verb) {
  verb.option("-b,--split-size", split_size, "Recording: a new file begins beyond this, such as 100MB");
  verb.option("-d,--split-duration", split_duration, "Recording: or after this time, such as 10min");
  verb.option("--max-size", max_size, "Recording: the oldest files go, so that all stay below this");
  verb.option("--compression", compression, "Of the recording: zstd, lz4 or none")
      .one_of({"zstd", "lz4", "none"});
}

bag::BagWriterOptions BagWriting::options(const std::string& path) const {
  if (splits() && std::filesystem::path(path).extension() == ".mcap")
    throw std::runtime_error(path + " is one file, and one file is not split: name a folder");
  bag::BagWriterOptions options{.split_size = size_option("--split-size", split_size, 1'000'000),
                                .split_duration = duration_option("--split-duration", split_duration),
                                .max_size = size_option("--max-size", max_size, 10'000'000)};
  if (options.max_size > 0 && options.split_size > options.max_size / 2)
    refuse("--split-size", split_size, "must be at most half of --max-size " + max_size);
  options.compression = compression == "none"  ? bag::Compression::none
                        : compression == "lz4" ? bag::Compression::lz4
                                               : bag::Compression::zstd;
  return options;
}

}  // namespace bw::cli
