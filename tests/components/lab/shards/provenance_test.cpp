#include "components/lab/shards/provenance.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(Provenance, IsTheSameFromItsJson) {
  const Provenance made = provenance_of("drives", 3, 8);
  EXPECT_EQ(provenance_from(to_json(made)), made);
  EXPECT_EQ(made.drives.size(), 64U);
  EXPECT_NE(provenance_of("other drives", 3, 8).drives, made.drives);
  EXPECT_EQ(difference(made, provenance_of("drives", 4, 8)), "");
}

}  // namespace
}  // namespace bw
