#include "components/robot_base/adaptor/emergency_stop_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "runtime/atomic_file.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/write_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

struct SavedButton {
  std::string writer, node;
  std::int64_t since = 0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("writer", writer, {.doc = "GID"});
    v("node", node, {.doc = "empty: not known"});
    v("since", since, {.unit = "ns", .doc = "since 1970"});
  }
  std::optional<std::string> violated_rule() const {
    const bool is_gid = writer.size() == 2 * std::tuple_size_v<EmergencyStop::Writer> &&
                        writer.find_first_not_of("0123456789abcdef") == std::string::npos;
    return is_gid ? std::nullopt : std::optional<std::string>("writer must be 32 hexadecimal digits");
  }
};

struct SavedStop {
  std::string cause;
  std::vector<SavedButton> pressed;

  template <class Visitor>
  void fields(Visitor& v) {
    v("cause", cause, {.doc = "what latched it"});
    v("pressed", pressed, {.doc = "buttons that were down"});
  }
  std::optional<std::string> violated_rule() const {
    return cause.empty() ? std::optional<std::string>("cause must not be empty") : std::nullopt;
  }
};

constexpr const char* kComment =
    "# The emergency stop of robot_base is latched. The service release_stop lets go of it and removes this file.\n";

std::string hex_of(const EmergencyStop::Writer& writer) {
  std::string text;
  for (const std::uint8_t byte : writer) text += fmt::format("{:02x}", byte);
  return text;
}

EmergencyStop::Writer writer_of(const std::string& hex) {
  EmergencyStop::Writer writer{};
  for (std::size_t i = 0; i < writer.size(); ++i)
    writer[i] = static_cast<std::uint8_t>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
  return writer;
}

}  // namespace

std::string text_of(const EmergencyStop::Record& record) {
  SavedStop saved{.cause = record.cause, .pressed = {}};
  for (const auto& button : record.pressed)
    saved.pressed.push_back({hex_of(button.writer), button.node, button.since.nanoseconds});
  return kComment + to_yaml(saved);
}

EmergencyStop::Record record_of(const ConfigNode& file) {
  SavedStop saved;
  read_into(saved, file, "");
  EmergencyStop::Record record{.cause = saved.cause, .pressed = {}};
  for (const SavedButton& button : saved.pressed)
    record.pressed.push_back({writer_of(button.writer), button.node, Time{button.since}});
  return record;
}

EmergencyStopFile::EmergencyStopFile(std::filesystem::path path,
                                     std::function<void(const std::string&)> complain)
    : path_(std::move(path)), complain_(std::move(complain)) {}

std::optional<EmergencyStop::Record> EmergencyStopFile::read() const {
  std::error_code error;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(path_, error));
  if (!is_there && (!error || error == std::errc::no_such_file_or_directory)) return std::nullopt;
  try {
    return record_of(load_yaml(path_));
  } catch (const std::exception& wrong) {
    return EmergencyStop::Record{
        .cause = std::string("what is known of an emergency stop cannot be read: ") + wrong.what(),
        .pressed = {}};
  }
}

void EmergencyStopFile::keep(const EmergencyStop::Record& record) {
  {
    const std::lock_guard lock(mutex_);
    next_ = record;
  }
  if (!jobs_) jobs_ = std::make_unique<BackgroundJobs>();
  jobs_->rethrow();
  jobs_->add([this] { write(); });
}

void EmergencyStopFile::write() {
  std::optional<EmergencyStop::Record> record;
  {
    const std::lock_guard lock(mutex_);
    record = std::exchange(next_, std::nullopt);
  }
  if (!record) return;
  try {
    if (record->cause.empty()) {
      std::filesystem::remove(path_);
      return;
    }
    using std::filesystem::perms;
    std::filesystem::create_directories(path_.parent_path());
    std::filesystem::permissions(path_.parent_path(), perms::owner_all);
    write_file_atomically(path_, text_of(*record));
    std::filesystem::permissions(path_, perms::owner_read | perms::owner_write);
  } catch (const std::exception& wrong) {
    complain_(std::string("the emergency stop will not be known to a process that is started anew: ") +
              wrong.what());
  }
}

std::optional<std::string> EmergencyStopFile::obstacle() const {
  std::filesystem::path folder = path_.parent_path();
  std::error_code ignored;
  while (!std::filesystem::exists(folder, ignored) && folder.has_relative_path())
    folder = folder.parent_path();
  if (access(folder.c_str(), W_OK | X_OK) == 0) return std::nullopt;
  return "an emergency stop will not be known to a process that is started anew: " + folder.string() +
         " cannot be written";
}

}  // namespace bw
