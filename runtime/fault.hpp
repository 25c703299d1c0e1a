// A fault: what goes wrong while a robot runs, on purpose. The graph names it (`faults:`, graph/fault_settings.hpp) and says when;
// a kind changes messages on their way, the clock of components, their parameters, or the process. One's own takes a few lines,
// in a program or a component library, as components do:
//
//   struct Dust final : bw::Fault {
//     void configure(bw::FaultSetup& setup) override {
//       setup.messages<sensor_msgs::msg::LaserScan>("scan", [](auto& scan, const bw::FaultTick&) {
//         scan.ranges().front() = 0.1F;
//         return bw::kPasses;
//       });
//     }
//   };
//   BW_FAULT(Dust, "laser_dust", "the first beam of each sweep ends at 0.1 m")
//
// Who hears a message hears what became of it, and so does a recording. What lock-step does is repeated to the byte.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/component.hpp"

namespace bw {

/// What becomes of a message.
struct Passage {
  bool is_lost = false;
  Duration held;  ///< it comes so much later, in steps of 10 ms
};

inline constexpr Passage kPasses{};
inline constexpr Passage kLost{.is_lost = true, .held = {}};

struct FaultTick {
  Time now;                     ///< of the component clock
  bool acts = true;             ///< false: before it begins, or after its end
  std::int64_t occurrence = 0;  ///< counts its beginnings from 0
  Duration since;               ///< its last beginning
};

/// Handed to Fault::configure().
class FaultSetup {
 public:
  virtual ~FaultSetup() = default;

  /// Of the kind, read strictly from `parameters` of the fault over the defaults of P.
  template <class P>
  P parameters() {
    P values;
    read_into(values, section(), path());
    keep_parameters(report_of(values, P{}));
    return values;
  }
  /// Changes messages of a topic, while it acts: `Passage change(M&, const FaultTick&)`. Whoever publishes it, on
  /// whichever lane: one at a time. The graph's `topic` stands for this one.
  template <class M, class Change>
  void messages(const std::string& topic, Change change) {
    add_typed<M>(topic, std::move(change), {});
  }
  /// Of a topic whose last message holds until the next one, as of a command: while it acts that one is said again each 10 ms,
  /// and once more when it is over.
  template <class M, class Change>
  void held_messages(const std::string& topic, Change change) {
    add_typed<M>(topic, std::move(change), {.holds = true});
  }
  /// All of them, also those that come when it does not act (FaultTick::acts).
  template <class M, class Change>
  void all_messages(const std::string& topic, Change change) {
    add_typed<M>(topic, std::move(change), {.always = true});
  }
  using ChangeBytes = std::function<Passage(std::vector<std::uint8_t>& cdr, const FaultTick&)>;
  /// Any type, as CDR with its encapsulation. `topic` may be empty: then the graph has to name one. `begins_with`: ROS name of
  /// the type that the first field must have; empty: any.
  void bytes(const std::string& topic, ChangeBytes change, const std::string& begins_with = {}) {
    add_gate({.topic = topic, .type = nullptr, .begins_with = begins_with, .change = std::move(change)});
  }
  /// Adds to the clock of the components that it is of: pure, of the time since it began.
  virtual void clock(std::function<Duration(Duration since)> error) = 0;
  using Step = std::function<void(const FaultTick&)>;
  /// Called when it begins and when it ends, on the lane of the first component that it is of. What began before the process did
  /// is not called.
  virtual void begins_and_ends(Step begin, Step end) = 0;
  /// Called every 10 ms while it acts, in the process that it is of, on a lane of the faults' own; not for what began before the
  /// process did.
  virtual void acts(Step step) = 0;
  /// It ends the process or brings it to a stand, and so needs somebody who starts it again: `bandwagon launch`. With
  /// `memory_limit` the graph must give that process one.
  virtual void is_of_a_process(bool memory_limit) = 0;
  /// `parameters` are not the kind's: they are names and values of the component that it is of, which has them while it acts.
  virtual void changes_parameters_of_component() = 0;
  /// Of the run, mixed with the fault's name.
  virtual std::uint64_t seed() const = 0;

 protected:
  struct Gate {
    std::string topic;
    const MessageType* type = nullptr;  ///< null: any
    std::string begins_with;
    ChangeBytes change;
    bool always = false;  ///< also when it does not act
    bool holds = false;   ///< the last one is said again while it acts
  };
  virtual void add_gate(Gate gate) = 0;
  virtual const ConfigNode& section() const = 0;
  virtual std::string path() const = 0;
  virtual void keep_parameters(ParameterReport report) = 0;

 private:
  template <class M, class Change>
  void add_typed(const std::string& topic, Change change, Gate gate) {
    static const MessageType kType{MessageTraits<M>::ros_name, MessageTraits<M>::dds_name,
                                   MessageTraits<M>::type_hash};
    gate.topic = topic;
    gate.type = &kType;
    gate.change = [message = std::make_shared<M>(), change = std::move(change)](
                      std::vector<std::uint8_t>& cdr, const FaultTick& tick) mutable {
      if (!deserialize(cdr, *message)) return kPasses;
      const Passage passage = change(*message, tick);
      if (!passage.is_lost) serialize(*message, cdr);
      return passage;
    };
    add_gate(std::move(gate));
  }
};

class Fault {
 public:
  virtual ~Fault() = default;
  /// Throws ConfigError.
  virtual void configure(FaultSetup& setup) = 0;
};

struct FaultKind {
  std::string name;
  std::string doc;  ///< one line
  std::function<std::unique_ptr<Fault>()> make;
};

/// Throws std::logic_error when the name is taken.
bool register_fault(FaultKind kind);
/// Sorted by name.
std::vector<FaultKind> registered_faults();

}  // namespace bw

/// Once per kind, in its source file.
#define BW_FAULT(Class, kind_name, doc)                                                 \
  namespace {                                                                           \
  [[maybe_unused]] const bool registered_fault_##Class =                                \
      ::bw::register_fault({kind_name, doc, [] { return std::make_unique<Class>(); }}); \
  }
