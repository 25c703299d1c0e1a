#include <iostream>

#include <fmt/format.h>

#include "runtime/cli/bag_verbs.hpp"
#include "runtime/cli/bag_words.hpp"
#include "runtime/recording/bag/convert.hpp"
#include "runtime/recording/bag/mcap_recover.hpp"

namespace bw::cli {

using nlohmann::json;

int bag_recover(const std::filesystem::path& path, const std::filesystem::path& out, bool as_json) {
  const bag::mcap::RecoveryReport report = bag::mcap::recover(path, out);
  std::vector<bag::BagFault> faults;
  for (const bag::mcap::Fault& fault : report.faults) faults.push_back({path, fault.offset, fault.what});
  if (as_json) {
    std::cout << json{{"path", path.string()},         {"out", out.string()},
                      {"messages", report.messages},   {"lost_bytes", report.lost_bytes},
                      {"was_whole", report.was_whole}, {"faults", to_json(faults)}}
                     .dump(2)
              << "\n";
  } else {
    for (const bag::BagFault& fault : faults) std::cout << "damage: " << in_words(fault) << "\n";
    std::cout << fmt::format("{} messages saved, {} bytes lost: {}\n", report.messages, report.lost_bytes,
                             out.string());
  }
  return report.lost_bytes == 0 ? 0 : 1;
}

int bag_convert(const std::filesystem::path& path, const std::filesystem::path& out,
                const std::string& compression, bool as_json) {
  const auto from = bag::open_bag(path);
  const auto chosen = bag::compression_of(compression == "none" ? "" : compression);
  const bag::ConvertReport report = convert(*from, out, chosen.value());
  if (as_json) {
    std::cout << json{{"path", path.string()},      {"out", out.string()},
                      {"compression", compression}, {"messages", report.messages},
                      {"size_bytes", report.size},  {"faults", to_json(report.lost)}}
                     .dump(2)
              << "\n";
  } else {
    for (const bag::BagFault& fault : report.lost) std::cout << "damage: " << in_words(fault) << "\n";
    std::cout << fmt::format("{} messages, {:.2f} MB: {}\n", report.messages,
                             static_cast<double>(report.size) * 1e-6, out.string());
  }
  return report.lost.empty() ? 0 : 1;
}

}  // namespace bw::cli
