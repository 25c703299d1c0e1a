// Our action clients as another program sees them on the wire, in the layouts of Humble and of Jazzy: its
// server, plain::ActionServer, shares no code with this project.
#include <set>

#include <gmock/gmock.h>

#include "tests/interop/action_ends.hpp"
#include "tests/interop/action_process.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/on_the_wire.hpp"
#include "tests/interop/plain/action_server.hpp"

namespace bw::test {
namespace {

using plain::goal_id;
using plain::GoalStatus;
using plain::to_hex;
using testing::ElementsAre;
using testing::SizeIs;

using Distros = testing::Types<Humble, Jazzy>;

/// The other way round: our client, and a server that is plain.
template <class Distro>
class ActionClientOnTheWire : public testing::Test {
 protected:
  ActionClientOnTheWire()
      : wire_(std::make_shared<plain::Wire>()),
        node_("plain", wire_, Distro::kGidSize),
        server_(std::make_unique<plain::ActionServer>(node_, "/plain", Distro::navigate_to_pose(),
                                                      Distro::no_result)),
        caller_({"call", Distro::kName}) {
    server_->accepts = [](const plain::Bytes& request) { return word_of(request) != "refuse"; };
  }

  /// The last text of a request.
  static std::string word_of(const plain::Bytes& request) {
    plain::CdrIn cdr(request);
    cdr.take(16 + 8);
    cdr.text();
    for (int i = 0; i < 7; ++i) cdr.number<double>();
    return cdr.text();
  }
  static plain::Bytes feedback(float left) {
    plain::CdrOut cdr;
    write_pose(cdr, 0.0);
    for (int i = 0; i < 4; ++i) cdr.number(std::int32_t{0});
    return cdr.number(std::int16_t{0}).number(left).bytes();
  }
  /// Does with each goal what its word says; false when the last one has been left.
  bool serve() {
    server_->answer();
    const auto code = [](std::uint16_t number, const std::string& text) {
      return [=](plain::CdrOut& cdr) { Distro::result(cdr, number, text); };
    };
    for (const plain::ActionServer::Goal& goal : std::vector(server_->goals())) {
      const plain::GoalId id = goal.state.info.id;
      const std::string word = word_of(goal.bytes);
      const GoalStatus status = goal.state.status;
      if (status == GoalStatus::accepted) {
        server_->execute(id);
        server_->feedback(goal_id(77), feedback(99.0F));  // of nobody's goal
        server_->feedback(id, feedback(1.0F));
      } else if (word == "cancel" && status == GoalStatus::canceling) {
        server_->finish(id, GoalStatus::canceled, code(0, ""));
      } else if (word == "end" && status == GoalStatus::executing) {
        server_->finish(id, GoalStatus::succeeded, code(0, ""));
      } else if (word == "abort" && status == GoalStatus::executing) {
        server_->finish(id, GoalStatus::aborted, code(103, "no path"));
      } else if (word == "leave") {
        return false;
      }
    }
    return true;
  }
  std::string seen() { return caller_.process().out() + caller_.process().err(); }

  std::shared_ptr<plain::Wire> wire_;
  plain::Node node_;
  std::unique_ptr<plain::ActionServer> server_;
  ActionProcess caller_;
};

TYPED_TEST_SUITE(ActionClientOnTheWire, Distros);

TYPED_TEST(ActionClientOnTheWire, GoalsEndAsTheServerSaysAndWithoutItWhenItIsGone) {
  ASSERT_TRUE(eventually([&] { return !this->serve(); })) << this->seen();
  std::vector<std::string> words;
  std::set<plain::GoalId> ids;
  for (const auto& goal : this->server_->goals()) {
    words.push_back(this->word_of(goal.bytes));
    ids.insert(goal.state.info.id);
    // Everything behind the id: the pose at x = 2.5 in map, and the word.
    const plain::Bytes expected = plain::with_goal_id(goal.state.info.id, navigate_goal(words.back()));
    EXPECT_EQ(to_hex(goal.bytes), to_hex(plain::padded(expected)));
    EXPECT_EQ(goal.state.info.id[6] >> 4U, 4) << "a random UUID, version 4";
    EXPECT_EQ(goal.state.info.id[8] >> 6U, 2);
  }
  EXPECT_THAT(words, ElementsAre("end", "cancel", "abort", "leave")) << "refuse was refused";
  EXPECT_THAT(ids, SizeIs(4));
  ASSERT_TRUE(eventually([&] {
    this->server_->answer();
    return this->seen().find("leave: feedback 1") != std::string::npos;
  })) << this->seen();
  this->server_.reset();
  ASSERT_EQ(this->caller_.process().wait(std::chrono::seconds(30)), 0) << this->seen();
  const bool has_codes = std::is_same_v<TypeParam, Jazzy>;
  EXPECT_EQ(this->caller_.process().out(),
            std::string("end: accepted\nend: feedback 1\nend: status 4") + (has_codes ? " 0 " : "") +
                "\ncancel: accepted\ncancel: feedback 1\ncancel: status 5" + (has_codes ? " 0 " : "") +
                "\nrefuse: refused\nabort: accepted\nabort: feedback 1\nabort: status 6" +
                (has_codes ? " 103 no path" : "") +
                "\nleave: accepted\nleave: feedback 1\nleave: status 0 without a result\n");
}

TYPED_TEST(ActionClientOnTheWire, ItsEndsAreThoseOfRos2) {
  ASSERT_TRUE(eventually([&] { return !this->server_->goals().empty() || !(this->server_->answer(), true); }))
      << this->seen();
  for (const ExpectedEnd& wanted : ends_of_server("/plain", TypeParam::navigate_to_pose())) {
    if (wanted.is_latched) continue;  // whoever follows its goals by their results needs no status
    const auto [gid, end] = foreign_end(this->node_, wanted.topic, !wanted.is_writer);
    EXPECT_EQ(end.type, wanted.type);
    if (!wanted.hash.empty()) {
      EXPECT_EQ(end.user_data, "typehash=" + wanted.hash + ";") << wanted.topic;
    }
    EXPECT_TRUE(end.is_reliable) << wanted.topic;
    EXPECT_TRUE(end.is_volatile) << wanted.topic;
  }
}

}  // namespace
}  // namespace bw::test
