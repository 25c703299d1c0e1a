#include "runtime/remote/web/bag_folder.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

namespace bw::web {
namespace {

constexpr int kDepth = 3;
constexpr std::size_t kMaxFiles = 2000;
constexpr int kNoLinks = O_NOFOLLOW | O_CLOEXEC;

struct Listed {
  std::string path;
  std::int64_t size = 0;
  double modified = 0;
};

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Other files beside recordings are nobody's business.
bool is_recording(std::string_view name) {
  return !name.starts_with('.') && (name.ends_with(".mcap") || name.ends_with(".db3"));
}

/// Appends what is in `folder`, which it closes.
void list_folder(int folder, const std::string& prefix, int depth, std::vector<Listed>& files) {
  DIR* const entries = fdopendir(folder);
  if (entries == nullptr) {
    ::close(folder);
    return;
  }
  while (const dirent* entry = readdir(entries)) {
    const std::string name = entry->d_name;
    struct stat status = {};
    if (name.starts_with('.') || fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (S_ISREG(status.st_mode) && is_recording(name)) {
      files.push_back({prefix + name, status.st_size, seconds(status.st_mtim)});
    } else if (S_ISDIR(status.st_mode) && depth < kDepth) {
      const int below = openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | kNoLinks);
      if (below >= 0) list_folder(below, prefix + name + '/', depth + 1, files);
    }
  }
  closedir(entries);
}

std::string etag_of(const struct stat& status) {
  return fmt::format("\"{:x}-{:x}-{:x}{:09x}\"", status.st_ino, status.st_size, status.st_mtim.tv_sec,
                     status.st_mtim.tv_nsec);
}

}  // namespace

ServedFile::~ServedFile() { ::close(descriptor_); }

std::size_t ServedFile::read(std::uint64_t from, char* into, std::size_t most) const {
  const ssize_t size = pread(descriptor_, into, most, static_cast<off_t>(from));
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

BagFolder::BagFolder(const std::filesystem::path& path)
    : folder_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0) throw std::runtime_error(fmt::format("{}: not a folder that can be read", path.string()));
}

BagFolder::~BagFolder() { ::close(folder_); }

std::string BagFolder::list() const {
  std::vector<Listed> files;
  const int again = openat(folder_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (again >= 0) list_folder(again, "", 0, files);
  if (files.size() > kMaxFiles) {
    std::sort(files.begin(), files.end(),
              [](const Listed& a, const Listed& b) { return a.modified > b.modified; });
    files.resize(kMaxFiles);
  }
  std::sort(files.begin(), files.end(), [](const Listed& a, const Listed& b) { return a.path < b.path; });
  nlohmann::json list = nlohmann::json::array();
  for (const Listed& file : files) {
    list.push_back({{"path", file.path}, {"size", file.size}, {"modified", file.modified}});
  }
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::variant<std::shared_ptr<const ServedFile>, FileRefusal> BagFolder::open(
    const std::vector<std::string>& segments) const {
  const auto none = [] { return FileRefusal{404, "there is no such file in the folder of bags"}; };
  if (segments.empty() || segments.size() > kDepth + 1 || !is_recording(segments.back())) return none();
  int folder = dup(folder_);
  for (std::size_t i = 0; i < segments.size() && folder >= 0; ++i) {
    const std::string& name = segments[i];
    const bool is_last = i + 1 == segments.size();
    struct stat status = {};
    const bool is_there = !name.empty() && !name.starts_with('.') &&
                          fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
    const bool is_link = is_there && S_ISLNK(status.st_mode);
    const bool fits = is_there && (is_last ? S_ISREG(status.st_mode) : S_ISDIR(status.st_mode));
    const int flags = is_last ? O_RDONLY | O_NONBLOCK : O_RDONLY | O_DIRECTORY;
    const int next = fits ? openat(folder, name.c_str(), flags | kNoLinks) : -1;
    ::close(std::exchange(folder, next));
    if (is_link) return FileRefusal{403, "links in the folder of bags are not followed"};
    if (is_there && !fits && is_last) return FileRefusal{403, "only regular files are served"};
    if (fits && next < 0) return FileRefusal{403, "the file cannot be read"};
  }
  struct stat status = {};
  if (folder < 0) return none();
  if (fstat(folder, &status) != 0 || !S_ISREG(status.st_mode)) {  // exchanged since it was looked at
    ::close(folder);
    return none();
  }
  return std::make_shared<const ServedFile>(folder, static_cast<std::uint64_t>(status.st_size),
                                            etag_of(status));
}

}  // namespace bw::web
