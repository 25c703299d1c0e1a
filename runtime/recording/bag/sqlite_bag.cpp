#include "runtime/recording/bag/sqlite_bag.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <sqlite3.h>

namespace bw::bag {
namespace {

constexpr std::uintmax_t kLeastLimit = 1'000'000;
constexpr std::uintmax_t kLargestValue = 1'000'000'000;  // SQLite's own limit [bytes]

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct FinishStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

/// A file may hold queries of its own, as views are, and pages that lead back to themselves: neither may keep
/// the reader for ever.
class Guard {
 public:
  /// `file_size` [bytes]. Must outlive the database's queries.
  Guard(sqlite3* database, std::uintmax_t file_size)
      : allowed_(kFewSteps + kStepsPerByte * static_cast<std::int64_t>(file_size)) {
    sqlite3_set_authorizer(database, &Guard::authorize, this);
    sqlite3_progress_handler(database, kStepsAtOnce, &Guard::count, this);
  }
  void begin() {
    left_ = allowed_;
    reason_.clear();
  }
  /// Of the query that failed last; empty: SQLite has its own.
  const std::string& reason() const { return reason_; }

 private:
  static constexpr int kStepsAtOnce = 100'000;
  static constexpr std::int64_t kFewSteps = 10'000'000;  // a tenth of a second
  static constexpr std::int64_t kStepsPerByte = 100;     // a message takes some 20, and at least 10 bytes

  static int authorize(void* self, int action, const char*, const char*, const char*, const char* view) {
    if (action != SQLITE_RECURSIVE && view == nullptr) return SQLITE_OK;
    static_cast<Guard*>(self)->reason_ = "it is read by its tables, and has a view in place of one";
    return SQLITE_DENY;
  }
  static int count(void* self) {
    auto& guard = *static_cast<Guard*>(self);
    guard.left_ -= kStepsAtOnce;
    if (guard.left_ > 0) return 0;
    guard.reason_ = "its pages lead on without an end";
    return 1;
  }

  std::int64_t allowed_;
  std::int64_t left_ = 0;
  std::string reason_;
};

/// A query and its current row. Columns count from 0.
class Query {
 public:
  Query(sqlite3* database, Guard& guard, const std::string& sql) : database_(database), guard_(guard) {
    guard.begin();
    sqlite3_stmt* raw = nullptr;
    is_valid_ = sqlite3_prepare_v2(database, sql.c_str(), -1, &raw, nullptr) == SQLITE_OK;
    statement_.reset(raw);
  }
  /// False where the file has no such table or column.
  bool is_valid() const { return is_valid_; }
  void bind(int index, std::int64_t value) { sqlite3_bind_int64(statement_.get(), index, value); }

  enum class Row { row, done, broken };
  Row next() {
    if (!is_valid_) return Row::broken;
    const int result = sqlite3_step(statement_.get());
    return result == SQLITE_ROW ? Row::row : result == SQLITE_DONE ? Row::done : Row::broken;
  }
  std::string error() const { return guard_.reason().empty() ? sqlite3_errmsg(database_) : guard_.reason(); }
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string text(int column) const {
    const auto* characters = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return characters == nullptr
               ? std::string()
               : std::string(characters,
                             static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
  }
  BytesView bytes(int column) const {
    const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return data == nullptr ? BytesView() : BytesView(data, static_cast<std::size_t>(size));
  }

 private:
  sqlite3* database_;
  Guard& guard_;
  std::unique_ptr<sqlite3_stmt, FinishStatement> statement_;
  bool is_valid_ = false;
};

class SqliteMessages final : public BagMessages {
 public:
  SqliteMessages(std::filesystem::path file, sqlite3* database, Guard& guard,
                 const std::map<std::int64_t, std::size_t>& topic_of, const std::string& only_topics,
                 const BagSelection& selection)
      : file_(std::move(file)),
        topic_of_(topic_of),
        query_(
            database, guard,
            "SELECT topic_id, timestamp, data, id FROM messages WHERE timestamp >= ?1 AND timestamp <= ?2" +
                only_topics + " ORDER BY timestamp, id") {
    query_.bind(1, selection.start.nanoseconds);
    const bool is_limited = selection.end != BagSelection{}.end;
    query_.bind(2, selection.end.nanoseconds - (is_limited ? 1 : 0));
  }

  Step next(BagMessage& message) override {
    while (!is_over_) {
      const Query::Row row = query_.next();
      if (row != Query::Row::row) {
        is_over_ = true;
        return row == Query::Row::done ? Step::end : Step::damaged;
      }
      const auto topic = topic_of_.find(query_.integer(0));
      if (topic == topic_of_.end()) continue;  // of a topic that the bag does not describe
      const Time time{query_.integer(1)};
      message = {.topic = topic->second, .log_time = time, .publish_time = time, .data = query_.bytes(2)};
      return Step::message;
    }
    return Step::end;
  }
  BagFault fault() const override { return {file_, 0, query_.error()}; }

 private:
  std::filesystem::path file_;
  const std::map<std::int64_t, std::size_t>& topic_of_;
  Query query_;
  bool is_over_ = false;
};

class SqliteBag final : public Bag {
 public:
  explicit SqliteBag(const std::filesystem::path& file) : file_(file) {
    sqlite3* raw = nullptr;
    // A write-ahead log beside the file may be needed; immutable would pass over it.
    const int result = sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
    database_.reset(raw);
    if (result != SQLITE_OK) fail(raw == nullptr ? "it cannot be opened" : sqlite3_errmsg(raw));
    // Nothing in the file can be longer than the file; SQLite needs some for itself.
    const std::uintmax_t most = std::clamp(std::filesystem::file_size(file), kLeastLimit, kLargestValue);
    sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, static_cast<int>(most));
    // Of a file that was cut, what is left is read; SQLite refuses it otherwise. Damage is looked for in
    // every page.
    sqlite3_exec(raw, "PRAGMA writable_schema=ON; PRAGMA cell_size_check=ON; PRAGMA trusted_schema=OFF",
                 nullptr, nullptr, nullptr);
    guard_ = std::make_unique<Guard>(raw, std::filesystem::file_size(file));
    read_topics();
    read_definitions();
    Query range(raw, *guard_, "SELECT MIN(timestamp), MAX(timestamp), COUNT(*) FROM messages");
    if (!range.is_valid()) fail("it has no table of messages (" + range.error() + ")");
    if (range.next() != Query::Row::row) {
      // Messages before the damage can be read all the same.
      faults_.push_back({file, 0, range.error()});
      return;
    }
    start_ = {range.integer(0)};
    end_ = {range.integer(1)};
    count_ = static_cast<std::uint64_t>(range.integer(2));
  }

  std::string storage() const override { return "sqlite3"; }
  std::string profile() const override { return "ros2"; }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  Time start() const override { return start_; }
  Time end() const override { return end_; }
  std::uint64_t message_count() const override { return count_; }
  std::vector<BagAttachment> attachments() const override { return {}; }
  std::optional<Bytes> attachment(const std::string&) const override { return std::nullopt; }
  const std::vector<BagFault>& faults() const override { return faults_; }
  std::vector<BagFault> verify() const override {
    Query query(database_.get(), *guard_, "PRAGMA quick_check(1)");
    if (query.next() != Query::Row::row) return {{file_, 0, query.error()}};
    if (query.text(0) == "ok") return {};
    return {{file_, 0, query.text(0)}};
  }

  std::map<std::string, std::map<std::string, std::string>> metadata() const override {
    Query query(database_.get(), *guard_, "SELECT metadata FROM metadata ORDER BY id DESC LIMIT 1");
    if (query.next() != Query::Row::row) return {};
    return {{"rosbag2", {{"serialized_metadata", query.text(0)}}}};
  }
  std::unique_ptr<BagMessages> messages(const BagSelection& selection) const override {
    std::string only;
    if (selection.topics) {
      for (const auto& [id, topic] : topic_of_) {
        if (selection.topics->contains(topics_[topic].name))
          only += (only.empty() ? "" : ",") + std::to_string(id);
      }
      only = " AND topic_id IN (" + only + ")";
    }
    return std::make_unique<SqliteMessages>(file_, database_.get(), *guard_, topic_of_, only, selection);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(file_.string() + " is no bag of SQLite: " + why);
  }

  void read_topics() {
    // Columns came with versions: QoS with 2, the hash with 4.
    for (const char* columns :
         {"offered_qos_profiles, type_description_hash", "offered_qos_profiles, ''", "'', ''"}) {
      Query query(database_.get(), *guard_,
                  std::string("SELECT id, name, type, serialization_format, ") + columns +
                      " FROM topics ORDER BY id");
      if (!query.is_valid()) continue;
      Query::Row row = query.next();
      for (; row == Query::Row::row; row = query.next()) {
        topic_of_[query.integer(0)] = topics_.size();
        topics_.push_back({.name = query.text(1),
                           .type = query.text(2),
                           .serialization_format = query.text(3),
                           .offered_qos_profiles = query.text(4),
                           .type_hash = query.text(5)});
      }
      if (row == Query::Row::broken) fail(query.error());
      count_messages();
      return;
    }
    fail(guard_->reason().empty() ? sqlite3_errmsg(database_.get()) : guard_->reason());
  }

  void count_messages() {
    Query query(database_.get(), *guard_, "SELECT topic_id, COUNT(*) FROM messages GROUP BY topic_id");
    while (query.next() == Query::Row::row) {
      const auto topic = topic_of_.find(query.integer(0));
      if (topic != topic_of_.end())
        topics_[topic->second].message_count = static_cast<std::uint64_t>(query.integer(1));
    }
  }

  void read_definitions() {
    Query query(database_.get(), *guard_,
                "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
    while (query.is_valid() && query.next() == Query::Row::row) {
      for (BagTopic& topic : topics_) {
        if (topic.type != query.text(0)) continue;
        topic.schema_encoding = query.text(1);
        topic.schema_text = query.text(2);
      }
    }
  }

  std::filesystem::path file_;
  std::unique_ptr<Guard> guard_;
  Database database_;
  std::vector<BagTopic> topics_;
  std::map<std::int64_t, std::size_t> topic_of_;  ///< by topic id
  std::vector<BagFault> faults_;
  Time start_;
  Time end_;
  std::uint64_t count_ = 0;
};

}  // namespace

std::unique_ptr<Bag> open_sqlite_file(const std::filesystem::path& file) {
  return std::make_unique<SqliteBag>(file);
}

}  // namespace bw::bag
