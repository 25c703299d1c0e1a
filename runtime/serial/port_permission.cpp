#include <algorithm>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/serial/open_line.hpp"

namespace bw {
namespace {

std::string group_name(gid_t group) {
  std::vector<char> space(16'384);
  struct group entry {};
  struct group* found = nullptr;
  getgrgid_r(group, &entry, space.data(), space.size(), &found);
  return found == nullptr ? std::to_string(group) : found->gr_name;
}

struct User {
  std::string name;
  gid_t group = 0;
};

User this_user() {
  std::vector<char> space(16'384);
  passwd entry{};
  passwd* found = nullptr;
  getpwuid_r(geteuid(), &entry, space.data(), space.size(), &found);
  return found == nullptr ? User{std::to_string(geteuid()), getegid()} : User{found->pw_name, found->pw_gid};
}

/// By the list of groups, in which a session that is older does not yet run.
bool is_member(const User& user, gid_t group) {
  int count = 256;
  std::vector<gid_t> groups(static_cast<std::size_t>(count));
  if (getgrouplist(user.name.c_str(), user.group, groups.data(), &count) < 0) return false;
  groups.resize(static_cast<std::size_t>(count));
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

}  // namespace

std::string why_not_permitted(const std::string& device) {
  struct stat status {};
  if (stat(device.c_str(), &status) != 0) return {};
  if (faccessat(AT_FDCWD, device.c_str(), R_OK | W_OK, AT_EACCESS) == 0) return {};
  const std::string group = group_name(status.st_gid);
  const User user = this_user();
  constexpr mode_t kGroupMay = S_IRGRP | S_IWGRP;
  if ((status.st_mode & kGroupMay) != kGroupMay || status.st_gid == 0)
    return "permission denied, and no group has access: install config/udev/99-bandwagon.rules (its first lines say how)";
  if (is_member(user, status.st_gid))
    return fmt::format(
        "permission denied: {} is in the group {}, this session is older: log out and in again, or `newgrp {}`",
        user.name, group, group);
  return fmt::format(
      "permission denied: the group {} may: `sudo usermod -aG {} {}`, then log out and in again", group,
      group, user.name);
}

}  // namespace bw
