// A Unix datagram socket that knows who writes: the kernel adds the sender's process and user to each datagram, and
// nobody can say another's.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace bw {

class CredentialSocket {
 public:
  /// Bound at `path`, for this user alone. One that is there already is taken away: whoever calls is known to be the only
  /// one. Throws std::runtime_error.
  explicit CredentialSocket(const std::filesystem::path& path);
  ~CredentialSocket();
  CredentialSocket(const CredentialSocket&) = delete;
  CredentialSocket& operator=(const CredentialSocket&) = delete;

  struct Datagram {
    pid_t pid = 0;  ///< 0: of another process namespace
    uid_t uid = 0;
    std::string text;
    std::string from;  ///< where an answer goes; empty: nobody waits for one
  };
  /// The oldest that waits; nothing where none does.
  [[nodiscard]] std::optional<Datagram> receive() const;
  void answer(const Datagram& question, const std::string& text) const;
  [[nodiscard]] int descriptor() const { return socket_; }

  /// Asks whoever is bound at `path`; nothing where nobody is, or nobody answers in time.
  static std::optional<std::string> ask(const std::filesystem::path& path, const std::string& text,
                                        std::chrono::milliseconds patience);

 private:
  std::filesystem::path path_;
  int socket_ = -1;
};

}  // namespace bw
