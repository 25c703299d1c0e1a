#include "components/lab/shards/kept.hpp"

#include <cctype>
#include <fstream>

#include <fmt/format.h>

#include "runtime/atomic_file.hpp"
#include "runtime/base/named_seed.hpp"

namespace bw {
namespace {

/// FNV-1a, 64 bits: told apart are versions of one piece, a handful.
std::string digest(const std::string& text) { return fmt::format("{:016x}", named_seed(text, 0)); }

}  // namespace

Kept::Kept(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::filesystem::path Kept::file_of(const std::string& name) const { return folder_ / (name + ".json"); }

std::optional<nlohmann::json> Kept::find(const std::string& name, const std::string& made_by) const {
  std::ifstream in(file_of(name));
  if (!in) return std::nullopt;
  nlohmann::json piece = nlohmann::json::parse(in, nullptr, false);
  if (!piece.is_object() || !piece.contains("value")) return std::nullopt;
  const auto found = piece.find("made_by");
  if (found == piece.end() || *found != digest(made_by)) return std::nullopt;
  return std::move(piece["value"]);
}

void Kept::put(const std::string& name, const std::string& made_by, const nlohmann::json& value) const {
  write_file_atomically(file_of(name),
                        nlohmann::json{{"made_by", digest(made_by)}, {"value", value}}.dump() + "\n");
}

std::string file_name_of(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return text;
}

}  // namespace bw
