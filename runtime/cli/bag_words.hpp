// What the verbs of `bandwagon bag` have in common: words, tables, JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/recording/bag/bag.hpp"

namespace bw::cli {

[[nodiscard]] std::string in_words(const bag::BagFault& fault);
[[nodiscard]] nlohmann::json to_json(const bag::BagFault& fault);
[[nodiscard]] nlohmann::json to_json(const std::vector<bag::BagFault>& faults);

/// [Hz] "10.00 Hz", or "-" for none.
[[nodiscard]] std::string rate_in_words(double hz);

/// Everything but topics: path, storage, profile, size, times, attachments, what was dropped while recording.
[[nodiscard]] nlohmann::json describe(const bag::Bag& recording, const std::filesystem::path& path);

/// One line from describe(), its topics included.
void print_head(const nlohmann::json& description);

/// Each column as wide as its widest text; `alignment` has '<' or '>' for each.
void print_table(const std::vector<std::vector<std::string>>& rows, std::string_view alignment);

}  // namespace bw::cli
