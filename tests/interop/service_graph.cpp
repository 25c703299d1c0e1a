// The project's side of a service, as a process of its own, for tests that sit on the other side:
//   service_graph serve    a node `server` with every service of service_examples.hpp and a few that take their time, and a
//                          node `limited` whose one parameter, limits.v_max, may change
//   service_graph call     a node `caller` that calls the examples of /plain/... one after the other and prints the replies
#include <csignal>
#include <cstdio>
#include <deque>
#include <memory>
#include <string>

#include "runtime/host/host.hpp"
#include "tests/interop/service_examples.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw::test {
namespace {

using std_srvs::srv::Empty;
using std_srvs::srv::SetBool;
using std_srvs::srv::Trigger;

template <class M>
std::vector<std::uint8_t> bytes_of(const M& message) {
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  return cdr;
}

Trigger::Response said(const std::string& text) {
  Trigger::Response response;
  response.success(true);
  response.message(text);
  return response;
}

/// Offered as /example/list_parameters and so on, beside the services of the node itself. What is not asked
/// by the example gets an empty response.
void offer_examples(Setup& setup) {
  for_each_example([&setup]<class S>(const Example<S>& example) {
    setup.service<S>(
        "/example/" + example.service, [example](const typename S::Request& request, const Tick&) {
          return bytes_of(request) == bytes_of(example.request) ? example.response : typename S::Response{};
        });
  });
}

/// `count` says how often it was asked; `later` answers at the next tick of 100 ms; `kept` answers when
/// `release` is called.
void offer_slow_ones(Setup& setup) {
  auto count = std::make_shared<int>(0);
  setup.service<Trigger>(
      "count", [count](const Trigger::Request&, const Tick&) { return said(std::to_string(++*count)); });
  auto later = std::make_shared<std::vector<Reply<Trigger>>>();
  setup.service<Trigger>("later", [later](const Trigger::Request&, const Reply<Trigger>& reply, const Tick&) {
    later->push_back(reply);
  });
  setup.every(Duration::milliseconds(100), "later", [later](const Tick&) {
    for (const Reply<Trigger>& reply : *later) reply(said("later"));
    later->clear();
  });
  auto kept = std::make_shared<std::deque<Reply<Trigger>>>();
  setup.service<Trigger>("kept", [kept](const Trigger::Request&, const Reply<Trigger>& reply, const Tick&) {
    kept->push_back(reply);
  });
  setup.service<Trigger>("release", [kept](const Trigger::Request&, const Tick&) {
    const std::size_t released = kept->size();
    for (const Reply<Trigger>& reply : *kept) reply(said("released"));
    kept->clear();
    return said(std::to_string(released));
  });
  const auto answer = [](bool ok, const std::string& text) {
    SetBool::Response response;
    response.success(ok);
    response.message(text);
    return response;
  };
  setup.service<SetBool>(
      "switch",
      [answer](const SetBool::Request& request, const Tick&) {
        return answer(true, request.data() ? "on" : "off");
      },
      [answer](const std::string& reason) { return answer(false, reason); });
}

struct Limits {
  double v_max = 0.75;
  void fields(auto& v) { v("v_max", v_max, {.min = 0, .max = 2, .doc = "top speed"}); }
};

struct LimitedOptions {
  Limits limits;
  void fields(auto& v) { v("limits", limits); }
};

/// All calls at once, in the hope of a server; the run ends when each has been answered or has run out of
/// time.
class Caller final : public Component {
 public:
  void configure(Setup& setup) override {
    for_each_example([&, this]<class S>(const Example<S>& example) {
      const Client<S> client = setup.client<S>("/plain/" + example.service, Need::optional);
      ++open_;
      calls_.push_back([this, client, example] {
        client.call(example.request, Duration::seconds(20.0),
                    [this, example](const typename S::Response* response, const Tick&) {
                      print(example.service,
                            response == nullptr ? std::vector<std::uint8_t>{} : bytes_of(*response));
                    });
      });
    });
    finish_ = setup.finish_run();
    setup.every(Duration::milliseconds(10), "call", [this](const Tick&) {
      for (const auto& call : std::exchange(calls_, {})) call();
    });
  }

 private:
  void print(const std::string& service, const std::vector<std::uint8_t>& cdr) {
    std::printf("%s ", service.c_str());
    for (const std::uint8_t byte : cdr) std::printf("%02x", byte);
    std::printf("\n");
    std::fflush(stdout);
    if (--open_ == 0) finish_(true, "all calls are over");
  }

  std::vector<std::function<void()>> calls_;
  std::function<void(bool, const std::string&)> finish_;
  int open_ = 0;
};

volatile std::sig_atomic_t g_is_asked_to_end = 0;

void end_when_asked(Setup& setup) {
  setup.every(Duration::milliseconds(50), "end", [finish = setup.finish_run()](const Tick&) {
    if (g_is_asked_to_end != 0) finish(true, "asked to end");
  });
}

int run(const std::string& role) {
  Graph graph;
  if (role == "serve") {
    graph.components.push_back(scripted({.name = "server"}, [](Setup& setup) {
      offer_examples(setup);
      offer_slow_ones(setup);
      end_when_asked(setup);
    }));
    graph.components.push_back(scripted({.name = "limited"}, [](Setup& setup) {
      setup.parameters<LimitedOptions>([](const LimitedOptions&, const Tick&) {});
    }));
  } else {
    register_component("caller", [] { return std::make_unique<Caller>(); });
    graph.components.push_back({.name = "caller", .type = "caller"});
  }
  std::signal(SIGTERM, [](int) { g_is_asked_to_end = 1; });
  Host host(graph, {.clock = ClockMode::wall});
  return host.run(Duration::seconds(600.0)).ok ? 0 : 1;
}

}  // namespace
}  // namespace bw::test

int main(int argc, char** argv) { return argc == 2 ? bw::test::run(argv[1]) : 2; }
