// Strict readers: good files, every way to be bad with its file and line, and the recorded sets where they
// are at hand.
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/files/shape_file.hpp"
#include "components/model/random.hpp"
#include "components/world/files/track_file.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kTrackHeader = "t_s,frame,ped_id,x_m,y_m,vx_mps,vy_mps\n";

template <class Read>
std::string complaint(Read read, const std::string& text) {
  std::istringstream input(text);
  try {
    read(input);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no complaint";
}

std::string track_complaint(const std::string& text) {
  return complaint([](std::istream& in) { read_tracks(in, "t.csv"); }, text);
}

TEST(TrackFile, ReadsTracksByRisingId) {
  std::istringstream input(kTrackHeader + "0.0,1,5,1.5,-2,0,0\r\n0.0,1,2,3,4,0,0\n0.4,11,5,1.9,-2,1,0\n\n");
  const auto tracks = read_tracks(input, "t.csv");
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 2u);
  EXPECT_EQ(tracks[1].id, 5u);
  ASSERT_EQ(tracks[1].samples.size(), 2u);
  EXPECT_EQ(tracks[1].samples[1].time, 0.4);
  EXPECT_EQ(tracks[1].samples[1].position, Vector2(1.9, -2.0));
}

TEST(TrackFile, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_THAT(track_complaint(""), StartsWith("t.csv:1: the header is missing"));
  EXPECT_THAT(track_complaint("t_s,x\n"), StartsWith("t.csv:1: "));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5,1,2,0,0\n0.4,2,5,nan,2,0,0\n"),
              StartsWith("t.csv:3: 'nan' is not a finite number"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5,1e999,2,0,0\n"), StartsWith("t.csv:2: '1e999'"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5,1.0x,2,0,0\n"), HasSubstr("'1.0x'"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5, 1,2,0,0\n"), HasSubstr("' 1'"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5,1,2,0\n"), StartsWith("t.csv:2: 6 values"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5,1,2,0,0,9\n"), StartsWith("t.csv:2: 8 values"));
  EXPECT_THAT(track_complaint(kTrackHeader + "\n0,1,5,1,2,0,0\n"), StartsWith("t.csv:2: '' is not"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,5.5,1,2,0,0\n"),
              HasSubstr("ped_id must be a whole number"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,-1,1,2,0,0\n"), HasSubstr("ped_id"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0,1,1,1e6,2,0,0\n"), HasSubstr("within 100000 m"));
  EXPECT_THAT(track_complaint(kTrackHeader + "0.4,1,5,1,2,0,0\n0.4,1,6,1,2,0,0\n0.4,1,5,1,2,0,0\n"),
              StartsWith("t.csv:4: t_s must rise"));
  EXPECT_THAT(track_complaint(kTrackHeader + std::string(5000, '1') + "\n"),
              StartsWith("t.csv:2: line longer"));
  EXPECT_THROW(read_tracks("no/such/file.csv"), std::runtime_error);
}

TEST(ShapeFile, ReadsWallsAndCircles) {
  std::istringstream walls("x1_m,y1_m,x2_m,y2_m\n6.000,2.000,0.000,2.000\n");
  const auto segments = read_walls(walls, "w.csv");
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].a, Vector2(6.0, 2.0));
  EXPECT_EQ(segments[0].b, Vector2(0.0, 2.0));
  std::istringstream circles("x_m,y_m,r_m\n-0.957,-5.126,0.2\n");
  EXPECT_EQ(read_circles(circles, "c.csv").at(0).radius, 0.2);
  EXPECT_THAT(complaint([](std::istream& in) { read_circles(in, "c.csv"); }, "x_m,y_m,r_m\n0,0,-1\n"),
              StartsWith("c.csv:2: r_m must not be negative"));
  EXPECT_THAT(
      complaint([](std::istream& in) { read_walls(in, "w.csv"); }, "x1_m,y1_m,x2_m,y2_m\n0,0,1e9,0\n"),
      StartsWith("w.csv:2: every value"));
}

TEST(TrackFile, AnyDamageIsEitherReadOrRefused) {
  // Random bytes into a good file: either tracks or a complaint that begins with file and line. Seed 5.
  const std::string good = kTrackHeader + "0.0,1,5,1.5,-2,0,0\n0.0,1,2,3,4,0,0\n0.4,11,5,1.9,-2,1,0\n";
  Random random(5);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = good;
    for (int i = 0; i < 3; ++i) text[random.bits() % text.size()] = static_cast<char>(random.bits() % 256);
    const std::string said = track_complaint(text);
    if (said != "no complaint") {
      EXPECT_THAT(said, StartsWith("t.csv:")) << "trial " << trial;
    }
  }
}

TEST(TrackFile, ReadsTheRecordedSets) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded people are not at hand";
  const std::string folder = std::string(shared) + "/data/eth_ucy_pedestrians/";
  EXPECT_EQ(read_tracks(folder + "eth.csv").size(), 360u);  // counts of the data's own README
  EXPECT_EQ(read_tracks(folder + "hotel.csv").size(), 390u);
  EXPECT_EQ(read_tracks(folder + "zara01.csv").size(), 148u);
  EXPECT_EQ(read_walls(folder + "hotel_walls.csv").size(), 4u);
  EXPECT_EQ(read_walls(folder + "zara01_walls.csv").size(), 7u);
  EXPECT_EQ(read_circles(folder + "hotel_circles.csv").size(), 3u);
}

}  // namespace
}  // namespace bw
