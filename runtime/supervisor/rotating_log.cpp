#include "runtime/supervisor/rotating_log.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bw {

RotatingLog::~RotatingLog() {
  if (file_ >= 0) close(file_);
}

bool RotatingLog::open() {
  if (file_ >= 0) return true;
  file_ = ::open(path_.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
  struct stat is {};
  if (file_ >= 0 && fstat(file_, &is) == 0) size_ = static_cast<std::uint64_t>(is.st_size);
  return file_ >= 0;
}

void RotatingLog::write(std::string_view text) {
  constexpr std::size_t kLastWords = 500;
  last_.append(text);
  if (last_.size() > kLastWords) last_.erase(0, last_.size() - kLastWords);
  if (size_ > 0 && size_ + text.size() > most_) {
    if (file_ >= 0) close(file_);
    file_ = -1;
    size_ = 0;
    std::error_code ignored;  // then the file grows, which is told by nobody's loss
    std::filesystem::rename(path_, path_.string() + ".1", ignored);
  }
  while (!text.empty()) {
    const ssize_t done = open() ? ::write(file_, text.data(), text.size()) : -1;
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) {
      fault_ = path_.string() + ": " + std::strerror(errno);
      lost_ += text.size();
      return;
    }
    size_ += static_cast<std::uint64_t>(done);
    text.remove_prefix(static_cast<std::size_t>(done));
  }
  fault_.clear();
}

std::string RotatingLog::last_words() const {
  const std::size_t end = last_.find_last_not_of('\n');
  if (end == std::string::npos) return {};
  const std::size_t begin = last_.find_last_of('\n', end);
  const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
  return last_.substr(first, end - first + 1);
}

}  // namespace bw
