#include "tests/interop/nav2_tree/service_leaf.hpp"

#include <algorithm>

#include "tests/interop/eventually.hpp"

namespace nav2 {

Status ClearCostmap::on_tick() {
  if (!asked_) {
    on_call_();
    at_ = Clock::now();
    asked_ = client_.send(CdrOut().number(std::uint8_t{0}).bytes());
  }
  const auto end = std::min(Clock::now() + kWaitInTick, at_ + kServerTimeout);
  if (bw::test::poll_until(end, kLook, [this] { return client_.take(*asked_).has_value(); })) {
    const std::chrono::duration<double> took = Clock::now() - at_;
    journal_.exchanges.push_back(
        {.what = service_, .at = journal_.since(at_), .took = took.count(), .accepted = true});
    asked_.reset();
    return Status::success;
  }
  if (Clock::now() - at_ < kServerTimeout) return Status::running;
  journal_.exchanges.push_back({.what = service_, .at = journal_.since(at_)});
  journal_.troubles.push_back(service_ + ": no answer within 20 ms");
  asked_.reset();
  return Status::failure;
}

}  // namespace nav2
