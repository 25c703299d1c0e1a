// Bags of several files, and the choice of how a path is read.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/bag_metadata.hpp"
#include "runtime/recording/bag/mcap_bag.hpp"
#include "runtime/recording/bag/sqlite_bag.hpp"

namespace bw::bag {
namespace {

/// The next message of each file, the oldest first; of one time the one of the earlier file.
class JoinedMessages final : public BagMessages {
 public:
  struct Source {
    std::unique_ptr<BagMessages> messages;
    const std::vector<std::size_t>* topic_of;  ///< of the file to that of the bag
    BagMessage next{};
    bool is_due = true;  ///< the next message must be read first
    bool is_over = false;
  };

  explicit JoinedMessages(std::vector<Source> sources) : sources_(std::move(sources)) {}

  Step next(BagMessage& message) override {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      Source& source = sources_[i];
      if (!std::exchange(source.is_due, false)) continue;
      const Step step = source.messages->next(source.next);
      if (step == Step::damaged) {
        source.is_due = true;
        damaged_ = i;
        return step;
      }
      source.is_over = step == Step::end;
    }
    std::size_t best = sources_.size();
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (sources_[i].is_over) continue;
      if (best == sources_.size() || sources_[i].next.log_time < sources_[best].next.log_time) best = i;
    }
    if (best == sources_.size()) return Step::end;
    message = sources_[best].next;
    message.topic = sources_[best].topic_of->at(message.topic);
    sources_[best].is_due = true;
    return Step::message;
  }
  BagFault fault() const override { return sources_[damaged_].messages->fault(); }

 private:
  std::vector<Source> sources_;
  std::size_t damaged_ = 0;
};

class JoinedBag final : public Bag {
 public:
  explicit JoinedBag(std::vector<std::unique_ptr<Bag>> files) : files_(std::move(files)) {
    for (const auto& file : files_) {
      std::vector<std::size_t>& topic_of = topic_of_.emplace_back();
      for (const BagTopic& topic : file->topics()) {
        const auto same =
            std::ranges::find_if(topics_, [&](const BagTopic& t) { return is_same_topic(t, topic); });
        topic_of.push_back(static_cast<std::size_t>(same - topics_.begin()));
        if (same == topics_.end()) {
          topics_.push_back(topic);
        } else {
          same->message_count += topic.message_count;
        }
      }
      faults_.insert(faults_.end(), file->faults().begin(), file->faults().end());
      if (file->message_count() == 0) continue;
      start_ = count_ == 0 ? file->start() : std::min(start_, file->start());
      end_ = count_ == 0 ? file->end() : std::max(end_, file->end());
      count_ += file->message_count();
    }
  }

  std::string storage() const override { return files_.front()->storage(); }
  std::string profile() const override { return files_.front()->profile(); }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  Time start() const override { return start_; }
  Time end() const override { return end_; }
  std::uint64_t message_count() const override { return count_; }
  const std::vector<BagFault>& faults() const override { return faults_; }
  std::vector<BagAttachment> attachments() const override {
    std::vector<BagAttachment> all;
    for (const auto& file : files_) std::ranges::copy(file->attachments(), std::back_inserter(all));
    return all;
  }
  std::optional<Bytes> attachment(const std::string& name) const override {
    for (const auto& file : files_) {
      if (auto found = file->attachment(name)) return found;
    }
    return std::nullopt;
  }
  std::map<std::string, std::map<std::string, std::string>> metadata() const override {
    std::map<std::string, std::map<std::string, std::string>> all;
    for (const auto& file : files_) {
      for (auto& [name, entries] : file->metadata()) all[name] = std::move(entries);
    }
    return all;
  }
  std::vector<BagFault> verify() const override {
    std::vector<BagFault> all;
    for (const auto& file : files_) std::ranges::copy(file->verify(), std::back_inserter(all));
    return all;
  }
  std::unique_ptr<BagMessages> messages(const BagSelection& selection) const override {
    std::vector<JoinedMessages::Source> sources;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      sources.push_back({.messages = files_[i]->messages(selection), .topic_of = &topic_of_[i]});
    }
    return std::make_unique<JoinedMessages>(std::move(sources));
  }

 private:
  std::vector<std::unique_ptr<Bag>> files_;
  std::vector<std::vector<std::size_t>> topic_of_;  ///< by file: its topics among those of the bag
  std::vector<BagTopic> topics_;
  std::vector<BagFault> faults_;
  Time start_;
  Time end_;
  std::uint64_t count_ = 0;
};

std::unique_ptr<Bag> open_file(const std::filesystem::path& path) {
  return path.extension() == ".db3" ? open_sqlite_file(path) : open_mcap_file(path);
}

/// Parts of a split recording carry a number before the ending: `drive_2.mcap` comes before `drive_10.mcap`.
bool by_number(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::string l = a.filename().string();
  const std::string r = b.filename().string();
  return l.size() != r.size() ? l.size() < r.size() : l < r;
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (const auto yaml = folder / "metadata.yaml"; std::filesystem::exists(yaml)) {
    for (const FileMetadata& file : read_bag_metadata(yaml).files) {
      const std::filesystem::path relative = file.path;
      const bool leaves = relative.is_absolute() || std::ranges::find(relative, "..") != relative.end();
      if (leaves)
        throw std::runtime_error(yaml.string() + ": names a file outside of its folder: " + file.path);
      files.push_back(folder / relative);
    }
    if (!files.empty()) return files;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".mcap" || extension == ".db3") files.push_back(entry.path());
  }
  std::ranges::sort(files, by_number);
  if (files.empty())
    throw std::runtime_error(folder.string() + " holds neither metadata.yaml nor .mcap nor .db3 files");
  return files;
}

}  // namespace

std::unique_ptr<Bag> open_bag(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return open_file(path);
  std::vector<std::unique_ptr<Bag>> files;
  for (const std::filesystem::path& file : files_of(path)) files.push_back(open_file(file));
  return join_bags(std::move(files));
}

std::unique_ptr<Bag> join_bags(std::vector<std::unique_ptr<Bag>> bags) {
  if (bags.size() == 1) return std::move(bags.front());
  return std::make_unique<JoinedBag>(std::move(bags));
}

}  // namespace bw::bag
