// The one folder of recordings that is served: regular files `.mcap` and `.db3`, and no others. Nothing
// outside of it can be reached: links are not followed, wherever they lead.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace bw::web {

/// An open file; closed with the last that holds it.
class ServedFile {
 public:
  ServedFile(int descriptor, std::uint64_t size, std::string etag)
      : descriptor_(descriptor), size_(size), etag_(std::move(etag)) {}
  ~ServedFile();
  ServedFile(const ServedFile&) = delete;
  ServedFile& operator=(const ServedFile&) = delete;

  std::uint64_t size() const { return size_; }       ///< when it was opened
  const std::string& etag() const { return etag_; }  ///< of its size, its time and its node
  std::size_t read(std::uint64_t from, char* into, std::size_t most) const;  ///< 0: no more, or not readable

 private:
  int descriptor_;
  std::uint64_t size_;
  std::string etag_;
};

struct FileRefusal {
  int status = 404;  ///< of HTTP
  std::string reason;
};

class BagFolder {
 public:
  /// Throws std::runtime_error where `path` is no folder.
  explicit BagFolder(const std::filesystem::path& path);
  ~BagFolder();
  BagFolder(const BagFolder&) = delete;
  BagFolder& operator=(const BagFolder&) = delete;

  /// `[{"path": "run/run_0.mcap", "size": 12345, "modified": 1700000000.5}, ...]`: recordings at most three
  /// folders deep, by path, the newest 2000 where there are more; time in seconds since 1970. What begins
  /// with a dot is neither told nor served.
  std::string list() const;
  std::variant<std::shared_ptr<const ServedFile>, FileRefusal> open(
      const std::vector<std::string>& segments) const;

 private:
  int folder_;
};

}  // namespace bw::web
