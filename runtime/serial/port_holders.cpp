#include "runtime/serial/port_holders.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace bw {
namespace {

namespace fs = std::filesystem;

int number(const fs::path& path) {
  const std::string name = path.filename().string();
  int value = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  return error == std::errc() && end == name.data() + name.size() ? value : -1;
}

bool is_same_port(const struct stat& a, const struct stat& b) {
  return a.st_rdev == b.st_rdev && (!is_pseudo_terminal(a.st_rdev) || a.st_dev == b.st_dev);
}

bool has_open(const fs::path& process, const struct stat& port, int except) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(process / "fd", error)) {
    struct stat status {};
    if (stat(entry.path().c_str(), &status) == 0 && S_ISCHR(status.st_mode) && is_same_port(status, port) &&
        number(entry.path()) != except)
      return true;
  }
  return false;
}

}  // namespace

bool is_pseudo_terminal(dev_t device) { return major(device) >= 136 && major(device) <= 143; }

std::vector<PortHolder> holders_of(const struct stat& port, int except, const SystemFolders& folders) {
  std::vector<PortHolder> holders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folders.proc, error)) {
    const int pid = number(entry.path());
    if (pid < 0 || !has_open(entry.path(), port, pid == getpid() ? except : -1)) continue;
    PortHolder holder{.pid = pid, .name = {}};
    std::ifstream comm(entry.path() / "comm");
    std::getline(comm, holder.name);
    holders.push_back(holder);
  }
  std::ranges::sort(holders, {}, &PortHolder::pid);
  return holders;
}

std::string in_words(const std::vector<PortHolder>& holders) {
  std::string words;
  for (const PortHolder& holder : holders)
    words += fmt::format("{}process {} ({})", words.empty() ? "" : ", ", holder.pid, holder.name);
  return words.empty() ? "a process of another user" : words;
}

}  // namespace bw
