#include <algorithm>
#include <condition_variable>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"
#include "runtime/wire/yaml.hpp"

namespace bw::cli {
namespace {

struct TopicOptions {
  std::string topic;
  std::string bag;
  bool types = false;
  bool verbose = false;
  bool json = false;
  bool once = false;
  double window_s = 0.0;
};

std::string qos_text(const Qos& qos) {
  return fmt::format("{} {}", qos.reliability == Reliability::reliable ? "RELIABLE" : "BEST_EFFORT",
                     qos.durability == Durability::transient_local ? "TRANSIENT_LOCAL" : "VOLATILE");
}

void list(const TopicOptions& options) {
  Outside outside;
  outside.settle();
  std::map<std::string, std::string> topics;
  for (const auto& endpoint : outside.endpoints())
    topics[ros_topic(endpoint.topic)] = ros_type(endpoint.type);
  if (options.json) {
    std::cout << nlohmann::json(topics).dump(2) << "\n";
    return;
  }
  for (const auto& [topic, type] : topics)
    std::cout << (options.types ? fmt::format("{} [{}]\n", topic, type) : topic + "\n");
}

std::vector<dds::Endpoint> endpoints_of(Outside& outside, const std::string& topic) {
  std::vector<dds::Endpoint> found;
  for (auto& endpoint : outside.endpoints()) {
    if (ros_topic(endpoint.topic) == topic) found.push_back(std::move(endpoint));
  }
  return found;
}

std::vector<dds::Endpoint> settled_endpoints_of(Outside& outside, const std::string& topic) {
  outside.settle([&] { return !endpoints_of(outside, topic).empty(); });
  return endpoints_of(outside, topic);
}

int info(const TopicOptions& options) {
  Outside outside;
  const auto ends = settled_endpoints_of(outside, options.topic);
  if (ends.empty()) {
    std::cerr << "Unknown topic '" << options.topic << "'\n";
    return 1;
  }
  const auto writers = std::ranges::count_if(ends, &dds::Endpoint::is_writer);
  std::cout << fmt::format("Type: {}\nPublisher count: {}\nSubscription count: {}\n",
                           ros_type(ends.front().type), writers,
                           static_cast<std::ptrdiff_t>(ends.size()) - writers);
  if (!options.verbose) return 0;
  for (const auto& end : ends) {
    std::cout << fmt::format("\nNode name: {}\nTopic type: {}\nEndpoint type: {}\nUser data: {}\nQoS: {}\n",
                             outside.node_of(end.guid), ros_type(end.type),
                             end.is_writer ? "PUBLISHER" : "SUBSCRIPTION", end.user_data, qos_text(end.qos));
  }
  return 0;
}

/// Subscribes with the strongest QoS that every publisher offers, as `ros2 topic echo` does.
class Subscription {
 public:
  explicit Subscription(const std::string& topic) {
    const auto ends = settled_endpoints_of(outside_, topic);
    if (ends.empty()) throw std::runtime_error("nobody publishes " + topic);
    Qos qos = Qos::standard();
    qos.durability = Durability::transient_local;
    for (const auto& end : ends) {
      if (!end.is_writer) continue;
      qos.reliability = std::min(qos.reliability, end.qos.reliability);
      qos.durability = std::min(qos.durability, end.qos.durability);
    }
    type_ = ends.front().type;
    type_hash_ = type_hash_in(ends.front().user_data);
    reader_ = outside_.participant().create_reader(
        {.topic = ends.front().topic, .type = type_, .qos = qos, .user_data = {}}, [this] {
          const std::lock_guard lock(mutex_);
          arrived_ = true;
          wake_.notify_one();
        });
  }
  const std::string& dds_type() const { return type_; }
  /// Empty where the publisher announces none.
  const std::string& type_hash() const { return type_hash_; }
  /// False when interrupted or `end` has passed.
  bool next(dds::Sample& sample, std::chrono::steady_clock::time_point end) {
    while (!interrupted() && std::chrono::steady_clock::now() < end) {
      if (reader_->take(sample)) return true;
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(100), [this] { return arrived_; });
      arrived_ = false;
    }
    return false;
  }

 private:
  Outside outside_;
  std::string type_;
  std::string type_hash_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
  std::unique_ptr<dds::Reader> reader_;
};

std::chrono::steady_clock::time_point end_of(const TopicOptions& options) {
  const auto now = std::chrono::steady_clock::now();
  if (options.window_s <= 0.0) return now + std::chrono::hours(24 * 365);
  return now + std::chrono::milliseconds(static_cast<std::int64_t>(options.window_s * 1e3));
}

int echo(const TopicOptions& options) {
  catch_interrupts();
  Subscription subscription(options.topic);
  const TypeDescription* type = find_type(subscription.dds_type(), subscription.type_hash());
  if (type == nullptr)
    throw std::runtime_error("no description of " + ros_type(subscription.dds_type()) + " is built in");
  dds::Sample sample;
  bool any = false;
  for (const auto end = end_of(options); subscription.next(sample, end);) {
    std::string error;
    if (!validate(*type, sample.cdr, &error)) {
      std::cerr << "rejected a sample: " << error << "\n";
      continue;
    }
    any = true;
    std::cout << to_yaml(*type, sample.cdr) << "---" << std::endl;
    if (options.once) break;
  }
  return any ? 0 : 1;
}

/// The same of a recording.
int echo_bag(const TopicOptions& options) {
  const auto recording = bag::open_bag(options.bag);
  const std::string name = join_namespaces("/", options.topic);
  std::vector<std::string_view> known;
  const bag::BagTopic* recorded = nullptr;
  for (const bag::BagTopic& topic : recording->topics()) {
    known.push_back(topic.name);
    if (topic.name == name) recorded = &topic;
  }
  if (recorded == nullptr)
    throw std::runtime_error(options.bag + ": " + name + ": " + unknown_rule("topic", name, known));
  const auto [type, why] = bag::known_type(*recorded);
  if (type == nullptr)
    throw std::runtime_error(why.empty() ? "no description of " + recorded->type + " is built in"
                                         : options.bag + ": " + name + " is not decoded: " + why);
  const auto messages = recording->messages({.topics = std::set<std::string>{name}});
  bool is_sound = true;
  bag::BagMessage message;
  for (bag::Step step = messages->next(message); step != bag::Step::end; step = messages->next(message)) {
    std::string error;
    if (step == bag::Step::damaged)
      error = fmt::format("byte {}: {}", messages->fault().offset, messages->fault().what);
    if (step == bag::Step::message && validate(*type, message.data, &error)) {
      std::cout << to_yaml(*type, message.data) << "---\n";
      if (options.once) return 0;
      continue;
    }
    std::cerr << options.bag << ": " << error << "\n";
    is_sound = false;
  }
  return is_sound ? 0 : 1;
}

int hz(const TopicOptions& options) {
  catch_interrupts();
  Subscription subscription(options.topic);
  dds::Sample sample;
  std::vector<double> gaps;
  auto last = std::chrono::steady_clock::time_point{};
  auto last_print = std::chrono::steady_clock::now();
  for (const auto end = end_of(options); subscription.next(sample, end);) {
    const auto now = std::chrono::steady_clock::now();
    if (last != std::chrono::steady_clock::time_point{})
      gaps.push_back(std::chrono::duration<double>(now - last).count());
    last = now;
    if (now - last_print < std::chrono::seconds(1) || gaps.empty()) continue;
    last_print = now;
    double sum = 0.0;
    for (const double gap : gaps) sum += gap;
    const auto [low, high] = std::ranges::minmax(gaps);
    std::cout << fmt::format("average rate: {:.3f}\n\tmin: {:.3f}s max: {:.3f}s window: {}\n",
                             static_cast<double>(gaps.size()) / sum, low, high, gaps.size())
              << std::flush;
  }
  return gaps.empty() ? 1 : 0;
}

void add_topic(Verb topic) {
  auto options = std::make_shared<TopicOptions>();
  Verb list_verb = topic.verb("list", "Names of all topics");
  list_verb.flag("-t,--show-types", options->types, "With their types");
  list_verb.flag("--json", options->json, "As JSON");
  list_verb.run([options] { list(*options); });
  Verb info_verb = topic.verb("info", "Type and ends of a topic");
  info_verb.option("TOPIC", options->topic).required();
  info_verb.flag("-v,--verbose", options->verbose, "Node, QoS and type hash of every end");
  info_verb.run([options] { return info(*options); });
  Verb echo_verb = topic.verb("echo", "Prints the messages of a topic as YAML");
  echo_verb.option("TOPIC", options->topic).required();
  echo_verb.flag("--once", options->once, "Only the first message");
  echo_verb.option("--for", options->window_s, "Ends after so many seconds");
  echo_verb.option("--bag", options->bag, "Of this recording, instead of the wire");
  echo_verb.run([options] { return options->bag.empty() ? echo(*options) : echo_bag(*options); });
  Verb hz_verb = topic.verb("hz", "Measures the rate of a topic");
  hz_verb.option("TOPIC", options->topic).required();
  hz_verb.option("--for", options->window_s, "Ends after so many seconds");
  hz_verb.run([options] { return hz(*options); });
}

}  // namespace

BW_VERB(look, "topic", "Topics on the wire", add_topic)

}  // namespace bw::cli
