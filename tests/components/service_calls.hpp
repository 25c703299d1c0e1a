// Requests of a script at given moments of a run in lock-step.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/component_rig.hpp"

namespace bw {

template <class S>
struct TimedRequest {
  double seconds;  ///< since the start; multiples of 0.01
  typename S::Request request;
};

/// Sends each request at its moment; the answers, in their order, are in `responses` when the run is over.
/// One that does not come within a second fails the test.
template <class S>
void call_at(Setup& setup, const std::string& service, std::vector<TimedRequest<S>> requests,
             std::vector<typename S::Response>& responses) {
  setup.every(
      Duration::milliseconds(10), "calls of " + service,
      [client = setup.client<S>(service), requests = std::move(requests), next = std::size_t{0}, &responses,
       service](const Tick& tick) mutable {
        constexpr double kRounding = 1e-6;
        while (next < requests.size() && seconds_since_start(tick.now) > requests[next].seconds - kRounding) {
          client.call(requests[next++].request, Duration::milliseconds(1000),
                      [&responses, service](const typename S::Response* response, const Tick&) {
                        if (response == nullptr) FAIL() << service << " did not answer";
                        responses.push_back(*response);
                      });
        }
      });
}

}  // namespace bw
