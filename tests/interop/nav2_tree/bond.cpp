#include "tests/interop/nav2_tree/bond.hpp"


namespace nav2 {
namespace {

plain::EndOptions end_of(int depth) {
  return {.topic = "rt/bond", .type = "bond::msg::dds_::Status_", .type_hash = {}, .depth = depth};
}

}  // namespace

Bonds::Bonds(plain::Node& node) : out_(node.create_writer(end_of(5))), in_(node.create_reader(end_of(100))) {
  node.announce();
}

void Bonds::say(const std::string& id, Bond& bond, bool is_active) {
  CdrOut out;
  write(out, Header{.stamp = {}, .frame = ""});
  out.text(id).text(bond.instance).number(static_cast<std::uint8_t>(is_active));
  out.number(std::chrono::duration<float>(kBondTimeout).count());
  out.number(std::chrono::duration<float>(kBeatPeriod).count());
  Bytes bytes = out.bytes();
  out_->write(&bytes);
  bond.said = Clock::now();
}

void Bonds::end(const std::string& id) {
  const auto found = bonds_.find(id);
  if (found == bonds_.end()) return;
  if (!found->second.is_broken) say(id, found->second, false);
  bonds_.erase(found);
}

void Bonds::poll() {
  Bytes bytes;
  plain::dds::SampleInfo info;
  while (bw::fast_dds::is_ok(in_->take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    CdrIn in(bytes);
    read_header(in);
    const auto found = bonds_.find(in.text());
    if (found == bonds_.end() || in.text() == found->second.instance) continue;
    Bond& bond = found->second;
    if (in.number<std::uint8_t>() != 0) {
      bond.is_formed = true;
      bond.heard = Clock::now();
    } else if (bond.is_formed) {
      bond.is_broken = true;
    }
  }
  for (auto& [id, bond] : bonds_) {
    if (bond.is_formed && Clock::now() - bond.heard > kBondTimeout) bond.is_broken = true;
    if (!bond.is_broken && Clock::now() - bond.said >= kBeatPeriod) say(id, bond, true);
  }
}

}  // namespace nav2
