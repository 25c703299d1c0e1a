// bandwagon bag info|check|recover|convert|import: recorded bags, looked at, mended, and made of tables.
#include <functional>
#include <memory>
#include <string>

#include "runtime/cli/bag_verbs.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::cli {
namespace {

struct BagArguments {
  std::string path;
  std::string out;
  std::string compression = "zstd";
  bool json = false;
};

void add_bag(Verb bag) {
  auto arguments = std::make_shared<BagArguments>();
  const auto verb = [&](const char* name, const char* what,
                        const std::function<int(const BagArguments&)>& action) {
    Verb one = bag.verb(name, what);
    one.option("BAG", arguments->path, "File or folder").required();
    one.flag("--json", arguments->json, "As JSON");
    one.run([arguments, action] { return action(*arguments); });
    return one;
  };
  verb("info", "What is in it, as it says itself", [](const auto& a) { return bag_info(a.path, a.json); });
  verb("check",
       "Whether it is sound, byte by byte: damage, order, content, gaps, clocks; exit status 1 if not",
       [](const auto& a) { return bag_check(a.path, a.json); });
  verb("recover", "Saves what can be saved of a damaged MCAP file; exit status 1 if something is lost",
       [](const auto& a) { return bag_recover(a.path, a.out, a.json); })
      .option("OUT", arguments->out, "New .mcap file")
      .required();
  Verb convert = verb("convert", "Writes it again, as MCAP; exit status 1 if something could not be read",
                      [](const auto& a) { return bag_convert(a.path, a.out, a.compression, a.json); });
  convert.option("OUT", arguments->out, "New .mcap file, or a folder").required();
  convert.option("--compression", arguments->compression, "zstd, lz4 or none")
      .one_of({"zstd", "lz4", "none"});
  bag.verb("import", "Of bandwagon-lab: a bag of CSV or white-space tables (config/imports/README.md)");
}

}  // namespace

BW_VERB(look, "bag", "Recorded bags: MCAP files, and the folders and SQLite files of rosbag2", add_bag)

}  // namespace bw::cli
