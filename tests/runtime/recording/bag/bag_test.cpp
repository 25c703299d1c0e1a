// Bags of any storage: what rosbag2 writes is read, folders as well as files.
#include "runtime/recording/bag/bag.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <unistd.h>

#include "runtime/recording/bag/bag_metadata.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using mcap::said_by;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// "topic time data" of every message.
std::vector<std::string> texts(const Bag& bag, const BagSelection& selection = {}) {
  std::vector<std::string> out;
  const auto messages = bag.messages(selection);
  for (BagMessage m; messages->next(m) == Step::message;) {
    out.push_back(bag.topics()[m.topic].name + " " + std::to_string(m.log_time.nanoseconds) + " " +
                  std::string(m.data.begin(), m.data.end()));
  }
  return out;
}

void write_mcap(const std::filesystem::path& file, const std::vector<mcap::Sample>& samples) {
  mcap::Writer writer(create_file(file), {});
  mcap::declare(writer);
  mcap::write_all(writer, samples);
  writer.close();
}

/// A SQLite bag as rosbag2 of the given schema version makes it.
void write_sqlite(const std::filesystem::path& file, int version) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  const std::string qos = version >= 2 ? ", offered_qos_profiles TEXT NOT NULL" : "";
  const std::string hash = version >= 4 ? ", type_description_hash TEXT NOT NULL" : "";
  const std::string qos_value = version >= 2 ? ", '- depth: 3'" : "";
  const std::string hash_value = version >= 4 ? ", 'RIHS01_aa'" : "";
  std::string sql =
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL" +
      qos + hash + ");" +
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL);" +
      "INSERT INTO topics VALUES(1, '/a', 'std_msgs/msg/String', 'cdr'" + qos_value + hash_value + ");" +
      "INSERT INTO topics VALUES(2, '/b', 'std_msgs/msg/Empty', 'cdr'" + qos_value + hash_value + ");" +
      "INSERT INTO messages VALUES(1, 1, 30, x'414243');" + "INSERT INTO messages VALUES(2, 2, 10, x'44');" +
      "INSERT INTO messages VALUES(3, 1, 30, x'45');";
  if (version >= 3) {
    sql +=
        "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
        "INSERT INTO schema VALUES(" +
        std::to_string(version) + ", 'x');";
  }
  if (version >= 4) {
    sql +=
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,"
        " encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);"
        "INSERT INTO message_definitions VALUES(1, 'std_msgs/msg/String', 'ros2msg', 'string data', 'RIHS01_aa');";
  }
  char* error = nullptr;
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK) << error;
  sqlite3_close(database);
}

class SqliteVersions : public ::testing::TestWithParam<int> {};

TEST_P(SqliteVersions, AreRead) {
  const mcap::Folder folder;
  write_sqlite(folder / "a_0.db3", GetParam());
  const auto bag = open_bag(folder / "a_0.db3");
  EXPECT_EQ(bag->storage(), "sqlite3");
  EXPECT_THAT(texts(*bag), ElementsAre("/b 10 D", "/a 30 ABC", "/a 30 E"));
  EXPECT_THAT(texts(*bag, {.start = {20}, .topics = {{"/a"}}}), ElementsAre("/a 30 ABC", "/a 30 E"));
  EXPECT_THAT(texts(*bag, {.topics = std::set<std::string>{}}), IsEmpty());
  EXPECT_EQ(bag->start().nanoseconds, 10);
  EXPECT_EQ(bag->end().nanoseconds, 30);
  EXPECT_EQ(bag->topics()[0].message_count, 2U);
  EXPECT_EQ(bag->topics()[0].offered_qos_profiles, GetParam() >= 2 ? "- depth: 3" : "");
  EXPECT_EQ(bag->topics()[0].type_hash, GetParam() >= 4 ? "RIHS01_aa" : "");
  EXPECT_EQ(bag->topics()[0].schema_text, GetParam() >= 4 ? "string data" : "");
}

/// Of a bag with one topic and `sql`.
std::string said_of_database(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
  return said_by([&] { static_cast<void>(open_bag(file)); });
}

// A view is a query that the file brings along: this one has no end, and `bag info` of it had none either.
TEST(SqliteBag, AViewIsNoTable) {
  const mcap::Folder folder;
  const std::string topics =
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT);";
  const std::string endless = "WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) ";
  const std::string view = "has a view in place of one";
  EXPECT_THAT(said_of_database(folder / "a.db3",
                               topics + "CREATE VIEW messages AS " + endless +
                                   "SELECT x AS id, 1 AS topic_id, x AS timestamp, x AS data FROM c"),
              HasSubstr(view));
  EXPECT_THAT(
      said_of_database(folder / "b.db3",
                       "CREATE VIEW topics AS " + endless +
                           "SELECT x AS id, 'a' AS name, 'b' AS type, 'cdr' AS serialization_format FROM c"),
      HasSubstr(view));
  EXPECT_THAT(said_of_database(folder / "c.db3", topics + "CREATE TABLE own(id, topic_id, timestamp, data);"
                                                          "CREATE VIEW messages AS SELECT * FROM own"),
              HasSubstr(view));
}

/// An inner page of a table (SQLite's file format, section 1.6) of 512 bytes whose 51 children are all the
/// same page.
std::string page_to(std::uint8_t child) {
  std::string page(512, '\0');
  page[0] = 5;
  page[4] = 50;  // cells
  page[5] = 1;   // and where they begin: 512 - 50 * 5 = 0x106
  page[6] = 6;
  page[11] = static_cast<char>(child);  // the rightmost
  for (std::size_t i = 0; i < 50; ++i) {
    const std::size_t at = 507 - 5 * i;
    page[at + 3] = static_cast<char>(child);
    page[at + 4] = 1;  // its key
    page[12 + 2 * i] = static_cast<char>(at >> 8);
    page[13 + 2 * i] = static_cast<char>(at & 0xff);
  }
  return page;
}

// Twelve pages, each 51 times the way to the next, are a table of 3e20 rows in 22 kB.
TEST(SqliteBag, PagesThatLeadOnWithoutAnEndAreGivenUp) {
  const mcap::Folder folder;
  static_cast<void>(said_of_database(
      folder / "a.db3",
      "PRAGMA page_size = 512; CREATE TABLE topics(id INTEGER PRIMARY KEY, name, type, serialization_format);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data);"
      "CREATE TABLE filler(data); INSERT INTO filler VALUES (zeroblob(20000));"
      "INSERT INTO topics VALUES (1, '/a', 'a/msg/A', 'cdr'); INSERT INTO messages VALUES (1, 1, 5, x'00')"));
  std::string file = mcap::content_of(folder / "a.db3");
  const auto page = [&](std::size_t number) {
    return file.begin() + static_cast<std::ptrdiff_t>((number - 1) * 512);
  };
  constexpr std::uint8_t kMessages = 3;  // page of the second table; those of the filler come after the third
  const std::string leaf(page(kMessages), page(kMessages + 1));
  for (std::uint8_t i = 0; i < 12; ++i) {
    const std::uint8_t from = i == 0 ? kMessages : 10 + i;
    std::ranges::copy(page_to(11 + i), page(from));
  }
  std::ranges::copy(leaf, page(22));
  mcap::write_content(folder / "b.db3", file);
  const auto bag = open_bag(folder / "b.db3");
  ASSERT_EQ(bag->faults().size(), 1U);
  EXPECT_THAT(bag->faults()[0].what, HasSubstr("lead on without an end"));
}

INSTANTIATE_TEST_SUITE_P(All, SqliteVersions, ::testing::Values(1, 2, 3, 4));

TEST(Bag, JoinsTheFilesOfAFolder) {
  const mcap::Folder folder;
  write_mcap(folder / "d_2.mcap", {{2, 5, 0, "x"}, {1, 40, 0, "late"}});
  write_mcap(folder / "d_10.mcap", {{1, 5, 0, "y"}, {2, 50, 0, "last"}});
  const auto bag = open_bag(folder / "");
  EXPECT_THAT(texts(*bag), ElementsAre("/b 5 x", "/a 5 y", "/a 40 late", "/b 50 last"));
  EXPECT_EQ(bag->message_count(), 4U);
  EXPECT_EQ(bag->topics()[0].message_count, 2U);
  EXPECT_EQ(bag->end().nanoseconds, 50);
}

TEST(Bag, FollowsMetadataYamlButNotOutOfItsFolder) {
  const mcap::Folder folder;
  write_mcap(folder / "one.mcap", {{1, 1, 0, "1"}});
  write_mcap(folder / "two.mcap", {{1, 2, 0, "2"}});
  mcap::write_content(folder / "metadata.yaml", to_yaml({.files = {{.path = "two.mcap"}}}));
  EXPECT_THAT(texts(*open_bag(folder / "")), ElementsAre("/a 2 2"));
  mcap::write_content(folder / "metadata.yaml", to_yaml({.files = {{.path = "../two.mcap"}}}));
  EXPECT_THAT(said_by([&] { (void)open_bag(folder / ""); }), HasSubstr("outside of its folder"));
}

TEST(Bag, RefusesWhatIsNone) {
  const mcap::Folder folder;
  EXPECT_THAT(said_by([&] { (void)open_bag(folder / ""); }), HasSubstr("neither metadata.yaml nor .mcap"));
  mcap::write_content(folder / "a.db3",
                      "not a database, but long enough to be looked at by SQLite as one, surely");
  EXPECT_THAT(said_by([&] { (void)open_bag(folder / "a.db3"); }), HasSubstr("a.db3 is no bag of SQLite"));
  mcap::write_content(folder / "b.db3", "");
  EXPECT_THAT(said_by([&] { (void)open_bag(folder / "b.db3"); }), HasSubstr("no such table"));
}

TEST(BagMetadata, ReadsBackWhatItWrites) {
  const mcap::Folder folder;
  const BagMetadata written{.start = 1'700'000'000'123'456'789,
                            .duration = 5,
                            .message_count = 7,
                            .topics = {{.name = "/odom",
                                        .type = "nav_msgs/msg/Odometry",
                                        .offered_qos_profiles = to_qos_text({Qos::latched()}),
                                        .type_hash = "RIHS01_00",
                                        .message_count = 7}},
                            .files = {{.path = "d_0.mcap", .start = 3, .duration = 4, .message_count = 7}},
                            .ros_distro = "humble"};
  mcap::write_content(folder / "metadata.yaml", to_yaml(written));
  const BagMetadata read = read_bag_metadata(folder / "metadata.yaml");
  EXPECT_EQ(read.version, 8);
  EXPECT_EQ(read.start, written.start);
  EXPECT_EQ(read.message_count, 7U);
  ASSERT_THAT(read.topics, SizeIs(1));
  EXPECT_EQ(read.topics[0].name, "/odom");
  EXPECT_THAT(from_qos_text(read.topics[0].offered_qos_profiles), ElementsAre(Qos::latched()));
  ASSERT_THAT(read.files, SizeIs(1));
  EXPECT_EQ(read.files[0].duration, 4U);
  EXPECT_EQ(read.topics[0].type_hash, "RIHS01_00");
  EXPECT_EQ(read.ros_distro, "humble");
}

// What `ros2 bag info` of Jazzy looks for, by the keys that rosbag2_storage/yaml.hpp (branch jazzy) demands
// from version 6 and from version 8 on.
TEST(BagMetadata, HasTheKeysOfItsVersion) {
  const std::string text = to_yaml({.ros_distro = "jazzy"});
  EXPECT_THAT(text, HasSubstr("\n  version: 8\n"));
  EXPECT_THAT(text, HasSubstr("\n  custom_data:\n    {}\n"));
  EXPECT_THAT(text, HasSubstr("\n  ros_distro: \"jazzy\"\n"));
}

/// As Jazzy writes it: words in a YAML list, hashes, newer keys.
constexpr const char* kVersion9 = R"(rosbag2_bagfile_information:
  version: 9
  storage_identifier: mcap
  duration:
    nanoseconds: 10
  starting_time:
    nanoseconds_since_epoch: 20
  message_count: 1
  topics_with_message_count:
    - topic_metadata:
        name: /scan
        type: sensor_msgs/msg/LaserScan
        serialization_format: cdr
        offered_qos_profiles:
          - history: keep_last
            depth: 5
            reliability: best_effort
            durability: transient_local
            deadline:
              sec: 9223372036
              nsec: 854775807
            lifespan:
              sec: 2
              nsec: 500000000
            liveliness: automatic
            liveliness_lease_duration:
              sec: 9223372036
              nsec: 854775807
            avoid_ros_namespace_conventions: false
        type_description_hash: RIHS01_00
      message_count: 1
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - a_0.mcap
  files:
    - path: a_0.mcap
      starting_time:
        nanoseconds_since_epoch: 20
      duration:
        nanoseconds: 10
      message_count: 1
  custom_data: ~
  ros_distro: jazzy
)";

TEST(BagMetadata, ReadsVersion9) {
  const mcap::Folder folder;
  mcap::write_content(folder / "metadata.yaml", kVersion9);
  const BagMetadata read = read_bag_metadata(folder / "metadata.yaml");
  ASSERT_THAT(read.topics, SizeIs(1));
  EXPECT_EQ(read.topics[0].type_hash, "RIHS01_00");
  EXPECT_EQ(read.ros_distro, "jazzy");
  EXPECT_THAT(from_qos_text(read.topics[0].offered_qos_profiles),
              ElementsAre(Qos{.reliability = Reliability::best_effort,
                              .durability = Durability::transient_local,
                              .depth = 5,
                              .lifespan = Duration::milliseconds(2500)}));
}

TEST(BagMetadata, NamesFileLineAndRule) {
  const mcap::Folder folder;
  std::string text = kVersion9;
  mcap::write_content(folder / "metadata.yaml", text.replace(text.find("version: 9"), 10, "version: 3"));
  EXPECT_THAT(said_by([&] { (void)read_bag_metadata(folder / "metadata.yaml"); }),
              HasSubstr("metadata.yaml:2: version 3 is not read"));
  text = kVersion9;
  mcap::write_content(folder / "metadata.yaml", text.erase(text.find("  message_count: 1"), 19));
  EXPECT_THAT(said_by([&] { (void)read_bag_metadata(folder / "metadata.yaml"); }),
              HasSubstr("message_count is missing"));
  mcap::write_content(folder / "metadata.yaml", "rosbag2: [");
  EXPECT_THAT(said_by([&] { (void)read_bag_metadata(folder / "metadata.yaml"); }),
              HasSubstr("metadata.yaml:1"));
}

TEST(QosText, IsWhatHumbleReads) {
  // Layout and numbers: rosbag2 humble, rmw/types.h.
  EXPECT_EQ(to_qos_text({Qos::sensor()}),
            "- history: 1\n  depth: 5\n  reliability: 2\n  durability: 2\n"
            "  deadline:\n    sec: 9223372036\n    nsec: 854775807\n"
            "  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n"
            "  liveliness: 1\n"
            "  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n"
            "  avoid_ros_namespace_conventions: false\n");
}

TEST(QosText, ADepthThatNobodyToldIsAnUnknownHistory) {
  // As rosbag2 writes what only discovery knows: RMW_QOS_POLICY_HISTORY_UNKNOWN is 3.
  EXPECT_THAT(to_qos_text({{.depth = 0}}), ::testing::StartsWith("- history: 3\n  depth: 0\n"));
}

TEST(QosText, ThePlayerOffersWhatAllAgreeOn) {
  EXPECT_EQ(playing_qos({}), Qos::standard(10));
  EXPECT_EQ(playing_qos({Qos::latched()}).durability, Durability::transient_local);
  EXPECT_EQ(playing_qos({Qos::latched(), Qos::standard()}), Qos::standard(10));
  EXPECT_EQ(playing_qos({Qos::tf()}).depth, 100);
  EXPECT_THAT(from_qos_text("not: a list"), IsEmpty());
  EXPECT_THAT(from_qos_text("[broken"), IsEmpty());
}

}  // namespace
}  // namespace bw::bag
