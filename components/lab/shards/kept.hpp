// Finished pieces of long work, one small file each in a folder, so that work that was killed goes on where
// it was. A piece that was made by another program or with other options is not found, and replaced when it
// is made again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace bw {

class Kept {
 public:
  explicit Kept(std::filesystem::path folder);

  /// What was put under this name, if all that it depends on was then as `made_by` says now. A file that
  /// cannot be read counts as none.
  [[nodiscard]] std::optional<nlohmann::json> find(const std::string& name, const std::string& made_by) const;

  /// The file appears whole or not at all. Throws std::runtime_error where it cannot be written.
  void put(const std::string& name, const std::string& made_by, const nlohmann::json& value) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(const std::string& name) const;

  std::filesystem::path folder_;
};

/// `text` as part of a file name: letters and digits, all else `_`.
std::string file_name_of(std::string text);

}  // namespace bw
