#include "runtime/remote/web/token.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bw::web {
namespace {

constexpr std::size_t kLongestToken = 1024;
constexpr std::size_t kMaxSessions = 64;
constexpr double kSessionLife = 12 * 3600;  // [s]
constexpr double kAttemptWindow = 60;       // [s]
constexpr std::size_t kMaxAddresses = 1024;

/// At most kLongestToken + 3 bytes of a file that only its owner can read.
std::string read_secret(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) throw std::runtime_error(fmt::format("{}: the token file cannot be read", path.string()));
  struct stat status = {};
  std::string wrong;
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    wrong = "a token file is a regular file";
  } else if (status.st_uid != geteuid() && status.st_uid != 0) {
    wrong = "the token file belongs to another user";
  } else if ((status.st_mode & 077) != 0) {
    wrong = fmt::format("the token file has mode {:o}: others can use it; chmod 600", status.st_mode & 0777);
  }
  std::array<char, kLongestToken + 3> text = {};
  const ssize_t size = wrong.empty() ? ::read(file, text.data(), text.size()) : 0;
  ::close(file);
  if (size < 0) wrong = "the token file cannot be read";
  if (!wrong.empty()) throw std::runtime_error(fmt::format("{}: {}", path.string(), wrong));
  return {text.data(), static_cast<std::size_t>(size)};
}

std::optional<std::string> from_base64(std::string_view text) {
  if (text.empty() || text.size() % 4 != 0 || text.size() > 4 * kLongestToken) return std::nullopt;
  std::vector<std::uint8_t> bytes(text.size() / 4 * 3);
  const int size = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const std::uint8_t*>(text.data()),
                                   static_cast<int>(text.size()));
  if (size < 0) return std::nullopt;
  const auto padding = static_cast<std::size_t>(std::count(text.end() - 2, text.end(), '='));
  return std::string(bytes.begin(), bytes.begin() + size - static_cast<std::ptrdiff_t>(padding));
}

}  // namespace

std::string read_token_file(const std::filesystem::path& path) {
  std::string token = read_secret(path);
  if (token.ends_with('\n')) token.pop_back();
  if (token.ends_with('\r')) token.pop_back();
  if (token.size() < kShortestToken || token.size() > kLongestToken) {
    throw std::runtime_error(fmt::format(
        "{}: the token has {} characters, {} to {} are needed; `openssl rand -hex 32` makes a good one",
        path.string(), token.size(), kShortestToken, kLongestToken));
  }
  if (!std::all_of(token.begin(), token.end(), [](char c) { return c > ' ' && c < 127; })) {
    throw std::runtime_error(
        fmt::format("{}: a token is one line of printable ASCII without spaces", path.string()));
  }
  return token;
}

bool is_equal_in_constant_time(std::string_view given, std::string_view secret) {
  unsigned difference = given.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const char expected = secret.empty() ? '\0' : secret[i % secret.size()];
    difference |= static_cast<unsigned char>(given[i] ^ expected);
  }
  return difference == 0 && !secret.empty();
}

std::optional<std::string> token_of(std::string_view authorization) {
  if (authorization.starts_with("Bearer ")) return std::string(authorization.substr(7));
  if (!authorization.starts_with("Basic ")) return std::nullopt;
  const auto pair = from_base64(authorization.substr(6));
  const std::size_t colon = pair ? pair->find(':') : std::string::npos;
  if (colon == std::string::npos) return std::nullopt;
  return pair->substr(colon + 1);
}

std::string random_text() {
  std::array<std::uint8_t, 16> bytes = {};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the system gives no random bytes");
  }
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::string Sessions::open(const std::string& address, double now) {
  if (sessions_.size() >= kMaxSessions) sessions_.pop_front();
  sessions_.push_back({random_text(), address, now});
  return sessions_.back().cookie;
}

bool Sessions::holds(std::string_view cookie, const std::string& address, double now) const {
  bool found = false;  // looks at all of them, so that time tells nothing
  for (const Session& session : sessions_) {
    found |= is_equal_in_constant_time(cookie, session.cookie) && session.address == address &&
             now - session.opened < kSessionLife;
  }
  return found;
}

void Sessions::close(std::string_view cookie) {
  std::erase_if(sessions_, [&](const Session& s) { return is_equal_in_constant_time(cookie, s.cookie); });
}

void Attempts::forget(double now) {
  for (auto& [address, times] : failures_) {
    while (!times.empty() && now - times.front() >= kAttemptWindow) times.pop_front();
  }
  std::erase_if(failures_, [](const auto& one) { return one.second.empty(); });
}

bool Attempts::may_try(const std::string& address, double now) {
  forget(now);
  const auto known = failures_.find(address);
  if (known == failures_.end()) return failures_.size() < kMaxAddresses;
  return known->second.size() < allowed_;
}

void Attempts::count_failure(const std::string& address, double now) { failures_[address].push_back(now); }

}  // namespace bw::web
