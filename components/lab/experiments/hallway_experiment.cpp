#include "components/lab/experiments/hallway_experiment.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/lab/bench/bench_common.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPhysicalLimit = 0.54;  // of the collision index, evaluation/theory.md 7.7
constexpr double kShareBelow = 0.8;

double figure(const nlohmann::json& card, const char* key) {
  const auto found = card.find(key);
  return found != card.end() && found->is_number() ? found->get<double>() : 0.0;
}

bool is_of(const HallwayRow& row, const HallwayDrive& drive) {
  return row.planner == drive.planner && row.episode == drive.episode &&
         row.people_react == drive.people_react && row.own_senses == drive.own_senses;
}

HallwayRow row_of(const std::vector<const HallwayDrive*>& drives) {
  const HallwayDrive& first = *drives.front();
  HallwayRow row{.planner = first.planner,
                 .episode = first.episode,
                 .people_react = first.people_react,
                 .own_senses = first.own_senses};
  row.drives = static_cast<int>(drives.size());
  std::vector<double> index, below, above_0_54, above_0_14, times, lengths;
  for (const HallwayDrive* drive : drives) {
    row.successes += drive->succeeded() ? 1 : 0;
    row.reached += drive->reached ? 1 : 0;
    row.contacts += drive->contacts;
    row.contacts_at_speed += drive->contacts_at_speed;
    index.push_back(drive->max_collision_index);
    below.push_back(drive->max_collision_index < kPhysicalLimit ? 1.0 : 0.0);
    above_0_54.push_back(drive->share_above_0_54);
    above_0_14.push_back(drive->share_above_0_14);
    if (!drive->reached) continue;
    times.push_back(drive->time);
    lengths.push_back(drive->path_length);
  }
  row.median_max_collision_index = quantile(index, 0.5);
  row.share_of_seeds_below_0_54 = mean(below);
  row.mean_share_above_0_54 = mean(above_0_54);
  row.mean_share_above_0_14 = mean(above_0_14);
  if (row.reached == 0) return row;
  row.mean_time = mean(times);
  row.mean_path_length = mean(lengths);
  return row;
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

const HallwayRow* find(const std::vector<HallwayRow>& rows, const std::string& planner,
                       const std::string& episode) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const HallwayRow& row) {
    return row.people_react && !row.own_senses && row.planner == planner && row.episode == episode;
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

HallwayDrive hallway_drive(const std::string& planner, const std::string& episode, bool people_react,
                           std::int64_t seed, const nlohmann::json& card) {
  HallwayDrive drive{.planner = planner, .episode = episode, .people_react = people_react, .seed = seed};
  drive.reached = card.value("reached", false);
  drive.contacts = static_cast<int>(figure(card, "collisions"));
  drive.contacts_at_speed = static_cast<int>(figure(card, "collisions_at_speed"));
  drive.max_collision_index = figure(card, "max_collision_index");
  drive.share_above_0_54 = figure(card, "share_ci_above_0_54");
  drive.share_above_0_14 = figure(card, "share_ci_above_0_14");
  drive.time = figure(card, "time_to_goal_s");
  drive.path_length = figure(card, "path_length_m");
  return drive;
}

std::vector<HallwayRow> hallway_rows(const std::vector<HallwayDrive>& drives) {
  std::vector<HallwayRow> rows;
  for (const HallwayDrive& first : drives) {
    if (std::any_of(rows.begin(), rows.end(), [&](const HallwayRow& row) { return is_of(row, first); }))
      continue;
    const HallwayRow setting{.planner = first.planner,
                             .episode = first.episode,
                             .people_react = first.people_react,
                             .own_senses = first.own_senses};
    std::vector<const HallwayDrive*> same;
    for (const HallwayDrive& drive : drives) {
      if (is_of(setting, drive)) same.push_back(&drive);
    }
    rows.push_back(row_of(same));
  }
  return rows;
}

std::vector<Criterion> hallway_criteria(const std::vector<HallwayRow>& rows,
                                        const std::vector<std::string>& order) {
  std::vector<Criterion> criteria;
  for (const char* episode : {"light", "full"}) {
    const HallwayRow* before = nullptr;
    for (const std::string& planner : order) {
      const HallwayRow* row = find(rows, planner, episode);
      if (row == nullptr) continue;
      if (before != nullptr) {
        const double rise = row->median_max_collision_index - before->median_max_collision_index;
        const auto add = [&](Criterion c) {
          criteria.push_back(over_seeds(std::move(c), static_cast<std::size_t>(row->drives), kHallwaySeeds));
        };
        add({fmt::format("{}, {}: median of the largest collision index above that of {}", episode, planner,
                         before->planner),
             "<= 0", rise, rise <= 0.0});
        add({fmt::format("{}, {}: share of seeds below {}", episode, planner, kPhysicalLimit),
             fmt::format(">= {}", kShareBelow), row->share_of_seeds_below_0_54,
             row->share_of_seeds_below_0_54 >= kShareBelow - 1e-9});
      }
      before = row;
    }
  }
  return criteria;
}

nlohmann::ordered_json hallway_json(const std::vector<HallwayDrive>& drives) {
  Json rows = Json::array();
  for (const HallwayRow& row : hallway_rows(drives)) {
    rows.push_back({{"planner", row.planner},
                    {"episode", row.episode},
                    {"people_react", row.people_react},
                    {"senses", row.own_senses ? "own" : "ideal"},
                    {"drives", row.drives},
                    {"successes", row.successes},
                    {"reached", row.reached},
                    {"contacts", row.contacts},
                    {"contacts_at_speed", row.contacts_at_speed},
                    {"median_max_collision_index", row.median_max_collision_index},
                    {"share_of_seeds_below_0_54", row.share_of_seeds_below_0_54},
                    {"mean_share_of_time_above_0_54", row.mean_share_above_0_54},
                    {"mean_share_of_time_above_0_14", row.mean_share_above_0_14},
                    {"mean_time_s", number(row.mean_time)},
                    {"mean_path_length_m", number(row.mean_path_length)}});
  }
  Json list = Json::array();
  for (const HallwayDrive& drive : drives) {
    list.push_back({{"planner", drive.planner},
                    {"episode", drive.episode},
                    {"people_react", drive.people_react},
                    {"senses", drive.senses()},
                    {"seed", drive.seed},
                    {"success", drive.succeeded()},
                    {"reached", drive.reached},
                    {"contacts", drive.contacts},
                    {"contacts_at_speed", drive.contacts_at_speed},
                    {"max_collision_index", drive.max_collision_index},
                    {"share_of_time_above_0_54", drive.share_above_0_54},
                    {"share_of_time_above_0_14", drive.share_above_0_14},
                    {"time_s", drive.time},
                    {"path_length_m", drive.path_length}});
    if (!drive.page.empty()) list.back()["page"] = drive.page;
  }
  return {{"success_means", kSuccessMeans}, {"rows", std::move(rows)}, {"drives", std::move(list)}};
}

std::string hallway_table(const std::vector<HallwayRow>& rows) {
  std::string out =
      fmt::format("{:<8} {:<6} {:<10} {:<24} {:>9} {:>9} {:>9} {:>10} {:>9} {:>13} {:>7} {:>7}\n", "hallway",
                  "senses", "people", "planner", "success", "contacts", "at speed", "CI median", "seeds<.54",
                  "time >.54 .14", "time s", "path m");
  for (const HallwayRow& row : rows) {
    out += fmt::format(
        "{:<8} {:<6} {:<10} {:<24} {:>9} {:>9} {:>9} {:>10.3f} {:>9.2f} {:>13} {:>7.2f} {:>7.2f}\n",
        row.episode, row.own_senses ? "own" : "ideal", row.people_react ? "react" : "do not", row.planner,
        fmt::format("{} of {}", row.successes, row.drives), row.contacts, row.contacts_at_speed,
        row.median_max_collision_index, row.share_of_seeds_below_0_54,
        fmt::format("{:.3f} {:.3f}", row.mean_share_above_0_54, row.mean_share_above_0_14),
        row.mean_time.value_or(0.0), row.mean_path_length.value_or(0.0));
  }
  return out;
}

}  // namespace bw
