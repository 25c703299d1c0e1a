#include "components/recordings/files/drive_of_bag.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <fmt/format.h>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/wheel_joints.hpp"
#include "components/recordings/files/drive_messages.hpp"
#include "components/recordings/summed_odometry.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::AnchorRange;
using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::TwistStamped;
using nav_msgs::msg::Odometry;
using sensor_msgs::msg::Imu;
using sensor_msgs::msg::JointState;
using sensor_msgs::msg::LaserScan;
using sensor_msgs::msg::NavSatFix;
using tf2_msgs::msg::TFMessage;

constexpr const char* kMounts = "/tf_static";

/// What became of the messages of one topic.
struct Counts {
  std::size_t malformed = 0;  ///< no message of the type
  std::size_t useless = 0;    ///< without a number of use
  std::size_t repeated = 0;   ///< of a stamp that was there already
};

/// By stamp, which falls where a recorder met messages late. Equal stamps are one moment of one sensor.
template <class Sample>
std::size_t put_in_order(std::vector<Sample>& samples) {
  std::ranges::stable_sort(samples, {}, &Sample::time);
  const auto rest = std::ranges::unique(samples, {}, &Sample::time);
  const auto count = static_cast<std::size_t>(rest.size());
  samples.erase(rest.begin(), rest.end());
  return count;
}

class DriveReader {
 public:
  DriveReader(const bag::Bag& bag, const DriveTopics& topics, const std::string& path,
              const WheelSizes& sizes)
      : bag_(bag), topics_(topics), path_(path) {
    read_log(sizes);
    const DriveTopics usual;
    add_travel(usual);
    add_kept(topics.imu, usual.imu, &DriveReader::on_imu);
    add_kept(topics.fixes, usual.fixes, &DriveReader::on_fix);
    add_kept(topics.ranges, usual.ranges, &DriveReader::on_range);
    for (const std::string& scans : topics.scans) {
      const bool is_usual = std::ranges::find(usual.scans, scans) != usual.scans.end();
      add_kept(scans, is_usual ? scans : "", &DriveReader::on_scan);
    }
    add_truth(usual.truth);
    if (handlers_.empty()) refuse_empty();
    add_kept(kMounts, kMounts, &DriveReader::on_mounts);
  }

  BagDrive read() {
    std::set<std::string> names;
    for (const auto& [topic, handler] : handlers_) names.insert(bag_.topics()[topic].name);
    const auto messages = bag_.messages({.topics = names});
    bag::BagMessage message;
    for (bag::Step step = messages->next(message); step != bag::Step::end; step = messages->next(message)) {
      if (step == bag::Step::damaged) {
        const bag::BagFault fault = messages->fault();
        result_.left_out.push_back(
            fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what));
      } else if (const auto handler = handlers_.find(message.topic); handler != handlers_.end()) {
        handler->second(message);
      }
    }
    finish();
    return std::move(result_);
  }

 private:
  using Handler = std::function<void(const bag::BagMessage&)>;

  RecordedDrive& drive() { return result_.drive; }

  void read_log(const WheelSizes& sizes) {
    result_.log = log_record_of(bag_, path_);
    drive().wheel_separation = result_.log.wheel_separation.value_or(sizes.separation);
    drive().wheel_variance = result_.log.wheel_variance.value_or(0.0);
    wheel_radius_ = result_.log.wheel_radius.value_or(sizes.radius);
  }

  /// True if the bag has the topic; then its messages go to `use`, which says whether they were of use. A
  /// name other than the usual one must be there.
  template <class Message, class Use>
  bool add(const std::string& topic, const std::string& usual, Use use) {
    bool found = false;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const bag::BagTopic& in_bag = bag_.topics()[i];
      if (in_bag.name != topic || topic.empty()) continue;
      found = true;
      if (in_bag.type != MessageTraits<Message>::ros_name)
        throw std::runtime_error(fmt::format("{}: {} is {}, and {} is needed", path_, topic, in_bag.type,
                                             MessageTraits<Message>::ros_name));
      if (const bag::KnownType known = bag::known_type(in_bag); known.type == nullptr)
        throw std::runtime_error(
            fmt::format("{}: {} is no {} of this build: {}", path_, topic, in_bag.type, known.why));
      handlers_[i] = [this, topic, use](const bag::BagMessage& in) {
        Message message;
        if (!deserialize(in.data, message)) {
          ++counts_[topic].malformed;
        } else if (!use(message, time_of(message, in))) {
          ++counts_[topic].useless;
        }
      };
    }
    if (!found && !topic.empty() && topic != usual)
      throw std::runtime_error(
          fmt::format("{}: there is no topic {}; there are: {}", path_, topic, topic_names()));
    return found;
  }

  void add_truth(const std::string& usual) {
    const auto found = std::ranges::find(bag_.topics(), topics_.truth, &bag::BagTopic::name);
    const std::string type = found == bag_.topics().end() ? "" : found->type;
    const auto keep_pose = [this](const geometry_msgs::msg::Pose& pose, Time time) {
      const auto reference = to_reference(pose, time);
      if (reference) drive().truth.push_back(*reference);
      return reference.has_value();
    };
    if (type == MessageTraits<Odometry>::ros_name) {
      add<Odometry>(topics_.truth, usual,
                    [=](const Odometry& m, Time time) { return keep_pose(m.pose().pose(), time); });
    } else if (type == MessageTraits<bandwagon_msgs::msg::GroundTruth>::ros_name) {
      add<bandwagon_msgs::msg::GroundTruth>(
          topics_.truth, usual, [=](const auto& m, Time time) { return keep_pose(m.pose(), time); });
    } else {
      add<PoseStamped>(topics_.truth, usual,
                       [=](const PoseStamped& m, Time time) { return keep_pose(m.pose(), time); });
    }
  }

  template <class Message>
  static Time time_of(const Message& message, const bag::BagMessage& in) {
    if constexpr (requires { message.header(); }) {
      const Time stamp = from_stamp(message.header().stamp());
      if (stamp != Time{}) return stamp;
    }
    return in.log_time;
  }

  template <class Message>
  bool add_kept(const std::string& topic, const std::string& usual,
                bool (DriveReader::*use)(const Message&, Time)) {
    return add<Message>(topic, usual,
                        [this, use](const Message& m, Time time) { return (this->*use)(m, time); });
  }

  void add_travel(const DriveTopics& usual) {
    if (add_kept(topics_.odometry, usual.odometry, &DriveReader::on_odometry)) return;
    if (add_kept(topics_.commands, usual.commands, &DriveReader::on_command)) return;
    add_kept(topics_.wheels, usual.wheels, &DriveReader::on_wheels);
  }

  template <class Message, class Sample>
  static bool keep(const Message& message, Time time, std::vector<Sample>& samples) {
    auto sample = to_sample(message, time);
    if (sample) samples.push_back(std::move(*sample));
    return sample.has_value();
  }

  bool on_odometry(const Odometry& message, Time time) { return keep(message, time, drive().odometry); }
  bool on_range(const AnchorRange& message, Time time) { return keep(message, time, drive().ranges); }
  bool on_scan(const LaserScan& message, Time time) { return keep(message, time, drive().scans); }
  bool on_imu(const Imu& message, Time time) {
    if (!message.header().frame_id().empty()) drive().imu_frame = message.header().frame_id();
    return keep(message, time, drive().imu);
  }
  bool on_fix(const NavSatFix& message, Time time) {
    if (!message.header().frame_id().empty()) drive().gps_frame = message.header().frame_id();
    return keep(message, time, drive().fixes);
  }
  bool on_mounts(const TFMessage& message, Time) {
    const std::vector<FrameMount> mounts = to_mounts(message);
    drive().mounts.insert(drive().mounts.end(), mounts.begin(), mounts.end());
    return true;
  }

  bool on_command(const TwistStamped& message, Time time) {
    const Twist2 twist = from_twist(message.twist());
    if (!is_finite(twist)) return false;
    if (summed_.add(time, twist, drive().odometry)) return true;
    throw std::runtime_error(
        fmt::format("{}: {}: a command cannot hold for more than {:.0f} s, as that before {:.3f} s does",
                    path_, topics_.commands, SummedCommands::kLongestHold.to_seconds(), time.to_seconds()));
  }

  bool on_wheels(const JointState& message, Time time) {
    if (!(wheel_radius_ > 0.0) || !(drive().wheel_separation > 0.0))
      throw std::runtime_error(fmt::format("{}: {}: nobody declares the wheels' {}", path_, topics_.wheels,
                                           wheel_radius_ > 0.0 ? "separation" : "radius"));
    const auto speeds = wheel_speeds_of(message, {wheel_radius_, wheel_radius_});
    if (!speeds || !std::isfinite(speeds->left) || !std::isfinite(speeds->right)) return false;
    add_measured(time, to_twist(*speeds, drive().wheel_separation), drive().odometry);
    return true;
  }

  std::string topic_names() const {
    std::string names;
    for (const bag::BagTopic& topic : bag_.topics()) names += (names.empty() ? "" : ", ") + topic.name;
    return names.empty() ? "none" : names;
  }

  [[noreturn]] void refuse_empty() const {
    throw std::runtime_error(fmt::format(
        "{}: nothing of a drive in it: neither odometry, commands nor wheels, imu, fixes, ranges, scans or "
        "a reference under the names in `topics`; its topics: {}",
        path_, topic_names()));
  }

  void finish() {
    RecordedDrive& d = drive();
    counts_[topics_.odometry].repeated += put_in_order(d.odometry);
    counts_[topics_.imu].repeated += put_in_order(d.imu);
    counts_[topics_.fixes].repeated += put_in_order(d.fixes);
    counts_[topics_.truth].repeated += put_in_order(d.truth);
    std::ranges::stable_sort(d.ranges, {}, &RangeSample::time);  // of several anchors
    std::ranges::stable_sort(d.scans, {}, &ScanSample::time);    // of several scanners
    result_.start = count_from(result_.log.start, d);
    if (!d.fixes.empty()) d.datum = d.fixes.front().position;
    for (const auto& [topic, counts] : counts_) {
      const auto tell = [&, &name = topic](std::size_t count, const char* what) {
        if (count > 0) result_.left_out.push_back(fmt::format("{}: {} messages {}", name, count, what));
      };
      tell(counts.malformed, "are no messages of its type");
      tell(counts.useless, "hold nothing of use: no finite numbers, no fix, or not measured");
      tell(counts.repeated, "have the stamp of another");
    }
  }

  const bag::Bag& bag_;
  const DriveTopics& topics_;
  const std::string& path_;
  BagDrive result_;
  double wheel_radius_ = 0.0;
  SummedCommands summed_;
  std::map<std::size_t, Handler> handlers_;  ///< by topic of the bag
  std::map<std::string, Counts> counts_;     ///< by topic
};

}  // namespace

BagDrive drive_of_bag(const bag::Bag& bag, const DriveTopics& topics, const std::string& path,
                      const WheelSizes& wheels) {
  return DriveReader(bag, topics, path, wheels).read();
}

}  // namespace bw
