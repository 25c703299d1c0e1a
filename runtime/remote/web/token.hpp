// The token that opens a server to other machines, the sessions of browsers that showed it, and how often it
// may be guessed.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace bw::web {

inline constexpr std::size_t kShortestToken = 16;  ///< [characters]

/// The one line of a file that is ours and that nobody else can read. Throws std::runtime_error naming file
/// and rule: not a regular file, of another user, readable by others, more than one line, shorter than
/// kShortestToken, characters that no header can carry.
std::string read_token_file(const std::filesystem::path& path);

/// Takes as long for any wrong text of the same length.
bool is_equal_in_constant_time(std::string_view given, std::string_view secret);

/// The token of `Authorization: Bearer TOKEN`, or the password of `Basic`, which is what browsers and
/// libraries make of ws://any:TOKEN@host.
std::optional<std::string> token_of(std::string_view authorization);

/// 128 bits of the system's generator as text.
std::string random_text();

/// Browsers that showed the token. A cookie counts from the address that got it, until it is closed, too old
/// or forgotten for newer ones.
/// Times are of a steady clock [s].
class Sessions {
 public:
  std::string open(const std::string& address, double now);
  bool holds(std::string_view cookie, const std::string& address, double now) const;
  void close(std::string_view cookie);

 private:
  struct Session {
    std::string cookie;
    std::string address;
    double opened = 0;
  };
  std::deque<Session> sessions_;
};

/// Wrong tokens of one address within a minute.
class Attempts {
 public:
  explicit Attempts(std::size_t allowed) : allowed_(allowed) {}
  bool may_try(const std::string& address, double now);
  void count_failure(const std::string& address, double now);

 private:
  void forget(double now);

  std::size_t allowed_;
  std::map<std::string, std::deque<double>> failures_;
};

}  // namespace bw::web
