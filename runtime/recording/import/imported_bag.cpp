#include "runtime/recording/import/imported_bag.hpp"

#include <cerrno>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <stdlib.h>

#include "runtime/recording/bag/bag_writer.hpp"

namespace bw::imports {
namespace {

class Messages final : public bag::BagMessages {
 public:
  Messages(const ImportedLog& log, bag::BagSelection selection)
      : log_(log), selection_(std::move(selection)) {}

  bag::Step next(bag::BagMessage& message) override {
    for (; next_ < log_.messages.size(); ++next_) {
      const ImportedMessage& m = log_.messages[next_];
      const bool in_time = m.stamp >= selection_.start && m.stamp < selection_.end;
      if (!in_time || (selection_.topics && !selection_.topics->contains(log_.topics[m.topic].name)))
        continue;
      message = {.topic = m.topic, .log_time = m.stamp, .publish_time = m.stamp, .data = m.data};
      ++next_;
      return bag::Step::message;
    }
    return bag::Step::end;
  }
  bag::BagFault fault() const override { return {}; }

 private:
  const ImportedLog& log_;
  bag::BagSelection selection_;
  std::size_t next_ = 0;
};

class ImportedBag final : public bag::Bag {
 public:
  explicit ImportedBag(ImportedLog log) : log_(std::move(log)) {}

  std::string storage() const override { return "tables"; }
  std::string profile() const override { return "ros2"; }
  const std::vector<bag::BagTopic>& topics() const override { return log_.topics; }
  Time start() const override { return log_.messages.empty() ? Time{} : log_.messages.front().stamp; }
  Time end() const override { return log_.messages.empty() ? Time{} : log_.messages.back().stamp; }
  std::uint64_t message_count() const override { return log_.messages.size(); }
  std::vector<bag::BagAttachment> attachments() const override { return {}; }
  std::optional<bag::Bytes> attachment(const std::string&) const override { return std::nullopt; }
  std::map<std::string, std::map<std::string, std::string>> metadata() const override {
    return log_.metadata;
  }
  const std::vector<bag::BagFault>& faults() const override { return faults_; }
  std::vector<bag::BagFault> verify() const override { return {}; }
  std::unique_ptr<bag::BagMessages> messages(const bag::BagSelection& selection) const override {
    return std::make_unique<Messages>(log_, selection);
  }

 private:
  ImportedLog log_;
  std::vector<bag::BagFault> faults_;
};

/// A folder beside the bag's place, where it is written and from where it is moved there in one step.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& folder) {
    std::string name = (folder / ".import-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), folder.string());
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::unique_ptr<bag::Bag> as_bag(ImportedLog log) { return std::make_unique<ImportedBag>(std::move(log)); }

void write_bag(const ImportedLog& log, const std::filesystem::path& path) {
  const std::filesystem::path target = std::filesystem::absolute(path).lexically_normal();
  const auto refuse_existing = [&path] {
    if (std::filesystem::exists(path)) throw std::runtime_error(path.string() + " exists already");
  };
  refuse_existing();
  std::filesystem::create_directories(target.parent_path());
  const TemporaryFolder workshop(target.parent_path());
  const std::filesystem::path made = workshop.path() / target.filename();
  {
    bag::BagWriter writer(made, {});
    for (const bag::BagTopic& topic : log.topics) writer.add_topic(topic);
    for (const auto& [name, entries] : log.metadata) writer.add_metadata(name, entries);
    for (const ImportedMessage& m : log.messages) writer.write(m.topic, m.stamp, m.stamp, m.data);
    writer.close();
  }
  refuse_existing();
  std::filesystem::rename(made, target);
}

}  // namespace bw::imports
