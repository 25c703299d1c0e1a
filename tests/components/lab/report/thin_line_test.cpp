#include "components/lab/report/thin_line.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace bw {
namespace {

using ::testing::ElementsAre;

TEST(ThinLine, KeepsWhatIsSeen) {
  std::vector<Vector2> line;
  for (int i = 0; i <= 100; ++i) line.emplace_back(i, i == 50 ? 3.0 : 0.0);
  // The ends, the spike, and the two points where it rises and falls.
  EXPECT_THAT(thin_line(line, 0.25),
              ElementsAre(Vector2(0, 0), Vector2(49, 0), Vector2(50, 3), Vector2(51, 0), Vector2(100, 0)));
  EXPECT_EQ(thin_line(line, 4.0).size(), 2U);
  EXPECT_THAT(thin_line({{0, 0}, {NAN, 0}, {1, 1}}, 0.25), ElementsAre(Vector2(0, 0), Vector2(1, 1)));
  EXPECT_EQ(thin_dots(line, 10.0).size(), 11U);
}

}  // namespace
}  // namespace bw
