#include "components/lab/report/columns.hpp"

#include "components/lab/report/number_json.hpp"

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Column& column) {
  Json json = {{"label", column.label}, {"color", column.color}};
  for (const double value : column.runs) json["runs"].push_back(number_json(value));
  if (column.measured)
    json["measured"] = {{"mean", number_json(column.measured->mean)},
                        {"low", number_json(column.measured->low)},
                        {"high", number_json(column.measured->high)}};
  if (column.published) json["published"] = number_json(*column.published);
  return json;
}

}  // namespace

Json to_json(const Columns& columns) {
  Json json = {{"kind", "columns"},
               {"title", columns.title},
               {"y", {{"label", columns.y.label}, {"low", columns.y.low}, {"high", columns.y.high}}},
               {"measured", columns.measured},
               {"runs", columns.runs},
               {"columns", Json::array()}};
  if (columns.y.logarithmic) json["y"]["log"] = true;
  for (const Column& column : columns.columns) json["columns"].push_back(to_json(column));
  for (const Limit& limit : columns.limits)
    json["limits"].push_back({{"value", limit.value}, {"label", limit.label}});
  return json;
}

}  // namespace bw::report
