#include "components/lab/leaderboard/board_reader.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bw {
namespace {

using Json = nlohmann::json;

std::optional<double> figure(const Json& drive, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    const auto found = drive.find(key);
    if (found != drive.end() && found->is_number()) return found->get<double>();
  }
  return std::nullopt;
}

// Of a world that is driven in at several times: what stands before the comma.
std::string start_of(const std::string& name) { return name.substr(0, name.find(',')); }

BoardDrive drive_of(const Json& json) {
  BoardDrive drive;
  drive.key = json.at("name").get<std::string>();
  drive.start = start_of(drive.key);
  if (json.contains("seed")) {
    const std::string seed = fmt::format(", seed {}", json.at("seed").get<std::int64_t>());
    drive.start = json.value("episode", drive.key) + seed;
    drive.key += seed;
  }
  drive.success = json.contains("success") ? json.at("success").get<bool>() : json.at("outcome") == "reached";
  drive.time = figure(json, {"time_s", "time_to_goal_s"});
  drive.path = figure(json, {"path_m", "path_length_m"});
  drive.jerk = figure(json, {"rms_jerk_mps3"});
  drive.score = figure(json, {"score"});
  drive.collision_index = figure(json, {"max_collision_index"});
  drive.cycle = json.contains("planner_ms") && json.at("planner_ms").is_object()
                    ? figure(json.at("planner_ms"), {"mean_ms"})
                    : figure(json, {"mean_ms"});
  if (json.contains("contacts") && json.at("contacts").is_array())
    for (const Json& contact : json.at("contacts")) drive.contacts.add(nlohmann::ordered_json(contact));
  drive.page = json.value("page", "");
  return drive;
}

std::string made_of(const Json& root) {
  if (!root.contains("made")) return "not told";
  const Json& made = root.at("made");
  std::string text = "revision " + made.value("revision", "?").substr(0, 12);
  for (const char* key : {"date", "command"})
    if (made.contains(key)) text += ", " + made.at(key).get<std::string>();
  return text;
}

class Suites {
 public:
  Suites(std::vector<BoardSuite>& suites, std::string label, std::string made)
      : suites_(suites), label_(std::move(label)), made_(std::move(made)) {}

  void add(const std::string& name, bool whole_graph, std::string planner, const Json& drives) {
    if (!label_.empty()) planner += " " + label_;
    auto suite = std::ranges::find(suites_, name, &BoardSuite::name);
    if (suite == suites_.end()) suite = suites_.insert(suite, {name, whole_graph, {}});
    if (suite->whole_graph != whole_graph)
      throw std::runtime_error(name + ": drives of planners alone and of whole graphs");
    if (std::ranges::find(suite->rows, planner, &BoardRow::planner) != suite->rows.end())
      throw std::runtime_error(fmt::format("{} of {} is there already", planner, name));
    suite->rows.push_back({planner, made_, {}});
    for (const Json& drive : drives) suite->rows.back().drives.push_back(drive_of(drive));
  }

 private:
  std::vector<BoardSuite>& suites_;
  std::string label_, made_;
};

// Of evaluate: planners are told drive by drive, with the variant under which they drove, which is a suite of its own.
void add_suite(Suites& suites, const Json& suite) {
  const std::string file = std::filesystem::path(suite.at("suite").get<std::string>()).stem().string();
  using Row = std::pair<std::string, std::string>;  // suite and planner
  std::vector<Row> order;
  std::map<Row, Json> drives;
  for (const Json& episode : suite.at("episodes")) {
    Row row{file, episode.at("planner").get<std::string>()};
    if (const std::string variant = episode.value("variant", ""); !variant.empty()) {
      row.first += ", " + variant;
      const std::size_t at = row.second.find(" " + variant);
      if (at != std::string::npos) row.second.erase(at, variant.size() + 1);
    }
    if (!drives.contains(row)) order.push_back(row);
    drives[row].push_back(episode);
  }
  for (const Row& row : order) suites.add(row.first, true, row.second, drives[row]);
}

void add_file(Suites& suites, const Json& root) {
  if (root.contains("suites")) {
    for (const Json& suite : root.at("suites")) add_suite(suites, suite);
  } else if (root.contains("suite")) {
    add_suite(suites, root);
  } else if (root.contains("rows")) {
    const std::string with =
        root.value("prediction", "") == "roll_out" ? ", people's own rule predicted" : "";
    for (const Json& row : root.at("rows"))
      suites.add(row.at("set").get<std::string>() + with, root.value("whole_graph", false), row.at("planner"),
                 row.at("drives"));
  } else if (root.contains("scene")) {
    const std::string name = fmt::format("CrowdNav's {}, robot {}{}", root.at("scene").get<std::string>(),
                                         root.value("visible", false) ? "visible" : "invisible",
                                         root.value("sampled", false) ? ", contacts sampled" : "");
    for (const Json& row : root.at("planners"))
      suites.add(name, false, row.at("planner"), row.at("episodes"));
  } else if (root.contains("crowds")) {
    for (const Json& crowd : root.at("crowds"))
      for (const Json& row : crowd.at("planners"))
        suites.add(crowd.at("name"), false, row.at("planner"), row.at("episodes"));
  } else if (root.contains("planners")) {
    for (const Json& row : root.at("planners"))
      suites.add("walkers who do not react", false, row.at("planner"), row.at("episodes"));
  } else if (root.contains("episodes")) {
    suites.add("walkers who do not react", false, root.at("planner"), root.at("episodes"));
  } else {
    throw std::runtime_error("holds no drives");
  }
}

}  // namespace

void read_board(const std::filesystem::path& file, std::vector<BoardSuite>& suites,
                const std::string& label) {
  try {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot be read");
    const Json root = Json::parse(in);
    Suites into(suites, label, made_of(root));
    add_file(into, root);
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

}  // namespace bw
