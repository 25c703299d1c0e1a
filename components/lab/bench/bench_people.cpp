#include "components/lab/bench/bench_people.hpp"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/people_picture.hpp"
#include "components/lab/bench/people_report.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {

int bench_people(const BenchPeopleArguments& arguments) {
  const PeopleRun run = run_people(*bag::open_bag(arguments.bag), arguments);
  std::fputs(people_text(run, arguments.show_errors).c_str(), stdout);
  write_json(arguments.json, people_json(run));
  if (!arguments.svg.empty()) write_file_atomically(arguments.svg, people_picture(run));
  return 0;
}

}  // namespace bw
