// A published value beside what is measured here: the one form in which every experiment tells it, for the
// page of all.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace bw {

/// Of one figure over the seeds. The quantiles are null in JSON where they say nothing, as of a share.
struct Spread {
  double mean = 0.0;
  double low = 0.0;   ///< quantile 5 %
  double high = 0.0;  ///< quantile 95 %
  std::size_t count = 0;
};

/// All NaN without a value.
Spread spread_of(const std::vector<double>& values);
/// `count` of which `part` are so.
Spread share_of(std::size_t part, std::size_t count);

/// The same measured by another reading of the source, such as the one that is printed.
struct OtherReading {
  std::string name;
  Spread here;
};

struct PublishedValue {
  std::string source;     ///< "Table 2.1"
  std::string what;       ///< "[x, y]: mean error of the filter"
  std::string unit;       ///< "m"; empty: a share or an index
  std::string published;  ///< as it is printed: "0.1451", "behind"
  Spread here;            ///< by the reading that is judged
  std::vector<OtherReading> others = {};
};

/// {mean, low, high, seeds}
nlohmann::ordered_json spread_json(const Spread& spread);

/// [{source, what, unit, published, here: {mean, low, high, seeds}, others: [{name, mean, low, high,
/// seeds}]}]
nlohmann::ordered_json published_json(const std::vector<PublishedValue>& values);

}  // namespace bw
