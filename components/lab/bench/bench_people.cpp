#include "components/lab/bench/bench_people.hpp"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/people_page.hpp"
#include "components/lab/bench/people_report.hpp"
#include "components/lab/report/report_page.hpp"

namespace bw {

int bench_people(const BenchPeopleArguments& arguments) {
  if (!arguments.page.empty()) require_report_page("--page " + arguments.page);
  const PeopleRun run = run_people(*bag::open_bag(arguments.bag), arguments);
  std::fputs(people_text(run, arguments.show_errors).c_str(), stdout);
  write_json(arguments.json, people_json(run));
  if (!arguments.page.empty()) write_report_page(people_page(run), arguments.page);
  return 0;
}

}  // namespace bw
