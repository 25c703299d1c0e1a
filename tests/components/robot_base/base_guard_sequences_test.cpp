// Everything that can happen to a base, in every order: bystander.hpp has what must never come of it.
#include <gtest/gtest.h>

#include "tests/components/robot_base/base_among_events.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

using test::Sequences;
using Base = BaseAmongEvents;

Sequences<Base> sequences(BaseGuardOptions options) {
  options.battery = {.low = 14.0, .empty = 13.0, .lasting = 0.05};
  return {.make = [options] { return Base(options); },
          .events = {{"forward", [](Base& b) { b.command(Base::Commands::forward); }},
                     {"stand", [](Base& b) { b.command(Base::Commands::zero); }},
                     {"no commands", [](Base& b) { b.command(Base::Commands::none); }},
                     {"bumper", [](Base& b) { b.bumper(); }},
                     {"cliff", [](Base& b) { b.cliff(); }},
                     {"wheel drop", [](Base& b) { b.wheel_drop(); }},
                     {"emergency stop", [](Base& b) { b.emergency_stop(); }},
                     {"release", [](Base& b) { b.release(); }},
                     {"cable", [](Base& b) { b.cable(); }},
                     {"reopened", [](Base& b) { b.reopen(); }},
                     {"charger", [](Base& b) { b.charger(); }},
                     {"fault", [](Base& b) { b.fault(); }},
                     {"battery", [](Base& b) { b.battery(); }},
                     {"blocked", [](Base& b) { b.block(); }},
                     {"clock back", [](Base& b) { b.step_clock(-3600.0); }},
                     {"clock on", [](Base& b) { b.step_clock(3600.0); }},
                     {"10 ms", [](Base& b) { b.pass(0.01); }},
                     {"100 ms", [](Base& b) { b.pass(0.1); }},
                     {"1 s", [](Base& b) { b.pass(1.0); }}},
          .broken = [](const Base& b) { return b.broken(); },
          .state = [](const Base& b) { return b.state(); }};
}

StopOptions all(Restart r) {
  return {.wheel_drop = r,
          .cliff = r,
          .bumper = r,
          .runaway = r,
          .stall = r,
          .link = r,
          .device = r,
          .battery = r,
          .charging = r};
}

TEST(BaseGuardSequences, AsItIs) {
  test::expect_unbroken("base from rest", sequences({}), test::sequence_depth(6));
}

TEST(BaseGuardSequences, FromADrive) {
  Sequences<Base> driving = sequences({});
  driving.make = [make = driving.make] {
    Base base = make();
    base.command(Base::Commands::forward);
    base.pass(1.0);
    return base;
  };
  test::expect_unbroken("base that drives", driving, test::sequence_depth(5));
}

TEST(BaseGuardSequences, OfEachRestartAndWithoutBackingOff) {
  for (const Restart restart : {Restart::released, Restart::if_idle, Restart::by_itself}) {
    const std::string name = "base, all restarts " + std::string(text_of(restart));
    test::expect_unbroken(name.c_str(), sequences({.restart = all(restart)}), test::sequence_depth(5));
  }
  test::expect_unbroken("base that does not back off", sequences({.contacts = {.back_off = false}}),
                        test::sequence_depth(5));
}

}  // namespace
}  // namespace bw
