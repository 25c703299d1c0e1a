// Labels in files: what is read, and how what is wrong is told.
#include "components/people/files/person_labels.hpp"

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bw::people {
namespace {

PersonLabels read(const std::string& text) {
  std::istringstream input(text);
  return read_person_labels(input, "labels.csv");
}

TEST(PersonLabels, AreReadInAnyOrderOfColumns) {
  const PersonLabels labels =
      read("frame,y,x,id,stamp\r\nmap,2,-1,7,1700000000.25\r\nodom,0,3,8,1700000000.25\r\n");
  EXPECT_TRUE(labels.has_stamps);
  ASSERT_EQ(labels.rows.size(), 2U);
  EXPECT_EQ(labels.rows[0].line, 2U);
  EXPECT_EQ(labels.rows[0].time, 1700000000.25);
  EXPECT_EQ(labels.rows[0].id, 7U);
  EXPECT_EQ(labels.rows[0].position, Vector2(-1.0, 2.0));
  EXPECT_EQ(labels.rows[0].frame, "map");
  EXPECT_TRUE(labels.rows[1].is_visible);
}

TEST(PersonLabels, SayWhoIsHidden) {
  const PersonLabels labels = read("time,id,x,y,frame,visible\n0,1,0,0,odom,0\n0.5,1,0,0,odom,1");
  EXPECT_FALSE(labels.has_stamps);
  EXPECT_FALSE(labels.rows[0].is_visible);
  EXPECT_TRUE(labels.rows[1].is_visible);
}

struct Bad {
  const char* text;
  const char* complaint;
};

class BadLabels : public testing::TestWithParam<Bad> {};

TEST_P(BadLabels, AreRefusedByFileLineColumnAndRule) {
  try {
    read(GetParam().text);
    FAIL() << "was read: " << GetParam().text;
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), GetParam().complaint);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Labels, BadLabels,
    testing::Values(
        Bad{"", "labels.csv:1: the header is missing"},
        Bad{"time,id,x,y,frame\n", "labels.csv:2: nobody is labelled"},
        Bad{"time,id,x,y\n0,1,0,0\n", "labels.csv:1: column 'frame' is missing"},
        Bad{"id,x,y,frame\n",
            "labels.csv:1: one of the columns 'time' (since the first scan) and 'stamp' must be there, and not both"},
        Bad{"time,stamp,id,x,y,frame\n",
            "labels.csv:1: one of the columns 'time' (since the first scan) and 'stamp' must be there, and not both"},
        Bad{"time,id,x,y,z,frame\n",
            "labels.csv:1: column 5, 'z', is unknown: columns are time or stamp, id, x, y, frame, visible"},
        Bad{"time,id,x,y,x,frame\n", "labels.csv:1: column 5, 'x', is there twice"},
        Bad{"time,id,x,y,frame\n0,1,0,0,odom\n1,1,nan,0,odom\n",
            "labels.csv:3: column x: 'nan' is not a finite number"},
        Bad{"time,id,x,y,frame\n0,1,0,inf,odom\n", "labels.csv:2: column y: 'inf' is not a finite number"},
        Bad{"time,id,x,y,frame\n0 s,1,0,0,odom\n", "labels.csv:2: column time: '0 s' is not a finite number"},
        Bad{"time,id,x,y,frame\n0,1.5,0,0,odom\n",
            "labels.csv:2: column id: '1.5' must be a whole number from 1 to 4294967295"},
        Bad{"time,id,x,y,frame\n0,0,0,0,odom\n",
            "labels.csv:2: column id: '0' must be a whole number from 1 to 4294967295"},
        Bad{"time,id,x,y,frame\n0,1,0,0,\n", "labels.csv:2: column frame: names no frame"},
        Bad{"time,id,x,y,frame,visible\n0,1,0,0,odom,2\n",
            "labels.csv:2: column visible: '2' must be a whole number from 0 to 1"},
        Bad{"time,id,x,y,frame\n0,1,0,0\n", "labels.csv:2: 4 values where the header names 5"},
        Bad{"time,id,x,y,frame\n1,1,0,0,odom\n\n2,1,0,0,odom\n",
            "labels.csv:3: 1 values where the header names 5"},
        Bad{"stamp,id,x,y,frame\n1,1,0,0,odom\n0.5,1,0,0,odom\n",
            "labels.csv:3: column stamp: is before that of line 2: times must not fall"},
        Bad{"time,id,x,y,frame\n1,1,0,0,odom\n1,2,0,0,odom\n1,1,0,0,odom\n",
            "labels.csv:4: column id: 1 is labelled twice at this time"}));

TEST(PersonLabels, NeedAFile) { EXPECT_THROW(read_person_labels("/nowhere/labels.csv"), std::runtime_error); }

}  // namespace
}  // namespace bw::people
