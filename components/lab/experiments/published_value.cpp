#include "components/lab/experiments/published_value.hpp"

#include <cmath>
#include <limits>

#include "components/lab/bench/bench_common.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  if (values.empty()) return {kNone, kNone, kNone, 0};
  return {mean(values), quantile(values, 0.05), quantile(values, 0.95), values.size()};
}

Spread share_of(std::size_t part, std::size_t count) {
  if (count == 0) return {kNone, kNone, kNone, 0};
  return {static_cast<double>(part) / static_cast<double>(count), kNone, kNone, count};
}

nlohmann::ordered_json spread_json(const Spread& spread) {
  return {{"mean", number(spread.mean)},
          {"low", number(spread.low)},
          {"high", number(spread.high)},
          {"seeds", spread.count}};
}

nlohmann::ordered_json published_json(const std::vector<PublishedValue>& values) {
  Json list = Json::array();
  for (const PublishedValue& value : values) {
    Json others = Json::array();
    for (const OtherReading& other : value.others) {
      Json one = {{"name", other.name}};
      one.update(spread_json(other.here));
      others.push_back(std::move(one));
    }
    list.push_back({{"source", value.source},
                    {"what", value.what},
                    {"unit", value.unit},
                    {"published", value.published},
                    {"here", spread_json(value.here)},
                    {"others", std::move(others)}});
  }
  return list;
}

}  // namespace bw
