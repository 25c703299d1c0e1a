// Nobody is there, and things look as if somebody were: what a drive takes with senses and without.
//   BANDWAGON_GAPS=50 build/release/bin/test_possible_people          all gaps, 12 fields of cylinders
//   BANDWAGON_PLANNERS=dwa,edwa,hrvo,teb,teb_homotopy,pteb,eteb       of other planners than eteb
//   BANDWAGON_SENSES=own,possible,person                              whose tracks (courses.hpp)
//   BANDWAGON_SET=component.param=value                               one more setting of the graph
//   BANDWAGON_CYLINDERS=FOLDER                                        and the fields of a folder, one CSV each
// The unit of the figures: one drive in lock-step, ideal localization, the laser of the simulated world.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/components/local_planner/possible/courses.hpp"

namespace bw {
namespace {

constexpr double kSlower = 1.2;  // times the time without a detector that a gap may take: the requirement

std::string setting(const char* name, const std::string& otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

int gaps() { return std::max(1, std::atoi(setting("BANDWAGON_GAPS", "5").c_str())); }
int fields() { return gaps() >= 50 ? 12 : 1; }

std::vector<std::string> planners() {
  std::vector<std::string> names;
  std::stringstream list(setting("BANDWAGON_PLANNERS", "eteb"));
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  return names;
}

std::vector<Senses> senses() {
  std::vector<Senses> all;
  std::stringstream list(setting("BANDWAGON_SENSES", "own,possible"));
  for (std::string name; std::getline(list, name, ',');) {
    all.push_back(name == "own" ? Senses::own : name == "possible" ? Senses::possible : Senses::person);
  }
  return all;
}

std::string text_of(const CourseDrive& drive) {
  return fmt::format("{} {:>6} contacts {}", drive.reached ? "reached" : "failed ",
                     drive.time ? fmt::format("{:.2f} s", *drive.time) : "-", drive.collisions);
}

std::string text_of(Senses senses) {
  return senses == Senses::own ? "own" : senses == Senses::possible ? "possible" : "person";
}

/// Of drives with some senses against those without.
struct Comparison {
  int count = 0;
  int passed_without = 0;
  int passed_with = 0;
  int slower = 0;             ///< not passed, or more than kSlower
  int slower_for_nobody = 0;  ///< of these, those in which no track was confirmed
  double worst = 0.0;
  double sum = 0.0;  ///< of the ratios

  void add(const CourseDrive& without, const CourseDrive& with) {
    ++count;
    passed_without += without.reached && without.collisions == 0 ? 1 : 0;
    passed_with += with.reached && with.collisions == 0 ? 1 : 0;
    if (!without.time) return;
    const double ratio = with.time ? *with.time / *without.time : 1e3;
    worst = std::max(worst, ratio);
    sum += ratio;
    slower += ratio > kSlower ? 1 : 0;
    slower_for_nobody += ratio > kSlower && with.confirmed == 0.0 ? 1 : 0;
  }
};

std::vector<CourseDrive> drives_without(const std::vector<Course>& courses, const std::string& planner) {
  std::vector<CourseDrive> drives;
  for (const Course& course : courses) drives.push_back(drive_course(course, planner, Senses::none));
  return drives;
}

Comparison compare(const std::vector<Course>& courses, const std::vector<CourseDrive>& drives,
                   const std::string& planner, Senses senses) {
  Comparison all;
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const CourseDrive& without = drives[i];
    const CourseDrive with = drive_course(courses[i], planner, senses);
    all.add(without, with);
    std::cout << fmt::format("{} {:2} {:14} none {}   {} {}   confidence {:.2f}, confirmed at once {:.2f}\n",
                             planner, i, courses[i].name, text_of(without), text_of(senses), text_of(with),
                             with.most_confident, with.confirmed)
              << std::flush;
  }
  std::cout
      << fmt::format(
             "{} {}: {} courses, passed {} without and {} with, {} take more than {:.1f}x, mean {:.3f}x, worst {:.2f}x\n",
             planner, text_of(senses), all.count, all.passed_without, all.passed_with, all.slower, kSlower,
             all.sum / std::max(1, all.count), all.worst)
      << std::flush;
  return all;
}

// The requirement: all fifty gaps, none slower than 1.2 times.
TEST(PossiblePeople, NeverCostAGapThatIsPassableAsAnObstacle) {
  std::vector<Course> courses;
  for (int i = 0; i < gaps(); ++i) courses.push_back(gap_course(i));
  for (const std::string& planner : planners()) {
    const std::vector<CourseDrive> without = drives_without(courses, planner);
    for (const Senses with : senses()) {
      const Comparison all = compare(courses, without, planner, with);
      // Whom nobody confirmed costs nothing. Any push, as any start some centimetres aside, may turn a choice
      // of bands that is a toss-up: with tracks of 0.49 on every post some drives take 2 s more and others 2
      // s less, so that there the mean counts.
      if (with == Senses::own) {
        EXPECT_EQ(all.slower_for_nobody, 0) << planner;
      } else if (with == Senses::possible) {
        EXPECT_LE(all.sum / all.count, 1.05) << planner;
      }
      // What the tracker confirms by mistake is a person: one gap of five may have one, of fifty none.
      const int confirmed_by_mistake = gaps() >= 50 ? 0 : 1;
      const int most = with == Senses::possible ? std::max(1, all.count / 10) : confirmed_by_mistake;
      EXPECT_LE(all.slower, most) << planner << " " << text_of(with);
      EXPECT_EQ(all.passed_with, all.passed_without) << planner << " " << text_of(with);
      EXPECT_EQ(all.passed_without, all.count) << "the course itself is too hard: it says nothing";
    }
  }
}

// Gaps of the fifty whose posts were confirmed when two that stand alone in a bare place were believed after
// 2 s: one was never passed.
TEST(PossiblePeople, AreNoPostsThatStandAlone) {
  std::vector<Course> courses;
  for (const int i : {32, 36, 38, 46, 48}) courses.push_back(gap_course(i));
  const Comparison all = compare(courses, drives_without(courses, "eteb"), "eteb", Senses::own);
  EXPECT_EQ(all.passed_with, 5);
  EXPECT_EQ(all.slower, 0);
}

TEST(PossiblePeople, LeaveFieldsOfCylindersPassable) {
  std::vector<Course> courses;
  for (int i = 0; i < fields(); ++i) courses.push_back(cylinder_course(i));
  if (const std::string folder = setting("BANDWAGON_CYLINDERS", ""); !folder.empty()) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".csv") files.insert(entry.path());
    }
    for (const auto& file : files) courses.push_back(course_of_file(file));
  }
  for (const std::string& planner : planners()) {
    const std::vector<CourseDrive> without = drives_without(courses, planner);
    for (const Senses with : senses()) {
      const Comparison all = compare(courses, without, planner, with);
      EXPECT_GE(all.passed_with, all.passed_without) << planner << " " << text_of(with);
    }
  }
}

}  // namespace
}  // namespace bw
