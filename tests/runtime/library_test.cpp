// Which faults are known of which Fast DDS. Expected: read from the history of its releases, tag by tag (July 2026).
#include "runtime/dds/library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::dds {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Library, IsOneOfThoseThatDebianHas) {
  EXPECT_THAT(to_string(library_version()), testing::AnyOf("2.9.1", "3.1.2"));
}

TEST(Library, NeitherOfDebiansHasTheMendsSinceOctober2025) {
  for (const LibraryVersion version : {LibraryVersion{2, 9, 1}, LibraryVersion{3, 1, 2}}) {
    EXPECT_THAT(known_faults(version),
                AllOf(Contains(HasSubstr("CVE-2025-62599")), Contains(HasSubstr("CVE-2025-62799")),
                      Contains(HasSubstr("CVE-2026-22591"))));
  }
}

TEST(Library, FaultsGoWithTheVersionThatMendsThem) {
  EXPECT_THAT(known_faults({2, 9, 1}), Contains(HasSubstr("CVE-2025-24807")));
  EXPECT_THAT(known_faults({3, 1, 2}), Not(Contains(HasSubstr("CVE-2025-24807"))));
  EXPECT_THAT(known_faults({2, 14, 6}), Not(Contains(HasSubstr("CVE-2025-62599"))));
  EXPECT_THAT(known_faults({2, 14, 6}), Contains(HasSubstr("CVE-2026-22591")));
  EXPECT_THAT(known_faults({3, 2, 4}), Not(Contains(HasSubstr("CVE-2025-62599"))));
  EXPECT_THAT(known_faults({3, 2, 4}), Contains(HasSubstr("CVE-2026-22591")));
  EXPECT_THAT(known_faults({3, 2, 5}), IsEmpty());
}

}  // namespace
}  // namespace bw::dds
