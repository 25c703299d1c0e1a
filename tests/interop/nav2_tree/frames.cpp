#include "tests/interop/nav2_tree/frames.hpp"

#include <algorithm>


namespace nav2 {
namespace {

constexpr const char* kType = "tf2_msgs::msg::dds_::TFMessage_";
constexpr std::size_t kMaxLinks = 10;

plain::EndOptions end(const std::string& topic, bool is_latched) {
  return {.topic = topic, .type = kType, .type_hash = {}, .depth = 100, .is_latched = is_latched};
}

/// In the plane.
Pose operator*(const Pose& parent, const Pose& child) {
  const double yaw = parent.yaw(), c = std::cos(yaw), s = std::sin(yaw);
  return Pose::of(parent.x + c * child.x - s * child.y, parent.y + s * child.x + c * child.y,
                  yaw + child.yaw());
}

}  // namespace

Frames::Frames(plain::Node& node)
    : moving_(node.create_reader(end("rt/tf", false))),
      fixed_(node.create_reader(end("rt/tf_static", true))) {
  node.announce();
}

void Frames::poll() {
  take(*moving_, false);
  take(*fixed_, true);
}

void Frames::take(plain::dds::DataReader& reader, bool is_static) {
  Bytes bytes;
  plain::dds::SampleInfo info;
  while (bw::fast_dds::is_ok(reader.take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    CdrIn in(bytes);
    for (auto left = in.number<std::uint32_t>(); left > 0; --left) {
      const Header header = read_header(in);
      const std::string child = in.text();
      Link link{.parent = header.frame,
                .stamp = header.stamp.sec + 1e-9 * header.stamp.nanosec,
                .is_static = is_static,
                .pose = read_pose(in)};
      if (link.stamp >= links_[child].stamp) links_[child] = link;
    }
  }
}

std::optional<std::vector<Frames::Link>> Frames::links_up() const {
  std::vector<Link> links;
  for (std::string frame = "base_link"; frame != "map"; frame = links.back().parent) {
    const auto found = links_.find(frame);
    if (found == links_.end() || links.size() == kMaxLinks) return std::nullopt;
    links.push_back(found->second);
  }
  return links;
}

std::optional<Pose> Frames::pose() const {
  const auto links = links_up();
  if (!links) return std::nullopt;
  Pose pose;
  for (const Link& link : *links) pose = link.pose * pose;
  return pose;
}

std::optional<double> Frames::age(double now) const {
  const auto links = links_up();
  if (!links) return std::nullopt;
  double oldest = now;
  bool moves = false;
  for (const Link& link : *links) {
    if (link.is_static) continue;
    oldest = moves ? std::min(oldest, link.stamp) : link.stamp;
    moves = true;
  }
  return now - oldest;
}

}  // namespace nav2
