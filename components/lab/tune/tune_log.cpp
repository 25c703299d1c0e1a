#include "components/lab/tune/tune_log.hpp"

#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace bw::tune {

TuneLog::TuneLog(const std::filesystem::path& file, const std::string& head) {
  std::string kept = head + "\n";
  if (std::ifstream in(file); in) {
    std::string line;
    std::getline(in, line);
    if (line != head)
      throw std::runtime_error(
          fmt::format("{} is of another tuning: \"{}\", not \"{}\"", file.string(), line, head));
    while (std::getline(in, line)) {
      if (in.eof()) break;  // cut
      std::istringstream words(line);
      std::size_t candidate = 0;
      std::uint64_t episode = 0;
      TuneDrive drive;
      if (!(words >> candidate >> episode >> drive.success >> drive.time >> drive.limit)) break;
      drives_[{candidate, episode}] = drive;
      kept += line + "\n";
    }
  }
  out_.open(file, std::ios::trunc);
  out_ << kept << std::flush;
  if (!out_) throw std::runtime_error(file.string() + ": cannot be written");
}

std::optional<TuneDrive> TuneLog::find(std::size_t candidate, std::uint64_t episode) const {
  const std::lock_guard lock(mutex_);
  const auto found = drives_.find({candidate, episode});
  return found == drives_.end() ? std::nullopt : std::optional(found->second);
}

void TuneLog::add(std::size_t candidate, std::uint64_t episode, const TuneDrive& drive) {
  const std::lock_guard lock(mutex_);
  drives_[{candidate, episode}] = drive;
  out_ << fmt::format("{} {} {} {} {}\n", candidate, episode, drive.success ? 1 : 0, drive.time, drive.limit)
       << std::flush;
  if (!out_) throw std::runtime_error("the log of the tuning cannot be written");
}

}  // namespace bw::tune
