// bandwagon bag info|check|recover|convert|import: recorded bags, looked at, mended, and made of tables.
#include <functional>
#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "runtime/cli/bag_import.hpp"
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

CLI::App* add_bag(CLI::App& app, int& status) {
  auto arguments = std::make_shared<BagArguments>();
  CLI::App* bag =
      app.add_subcommand("bag", "Recorded bags: MCAP files, and the folders and SQLite files of rosbag2")
          ->require_subcommand(1);
  const auto verb = [&](const char* name, const char* what,
                        const std::function<int(const BagArguments&)>& action) {
    CLI::App* one = bag->add_subcommand(name, what);
    one->add_option("BAG", arguments->path, "File or folder")->required();
    one->add_flag("--json", arguments->json, "As JSON");
    one->callback([arguments, &status, action] { status = action(*arguments); });
    return one;
  };
  verb("info", "What is in it, as it says itself", [](const auto& a) { return bag_info(a.path, a.json); });
  verb("check",
       "Whether it is sound, byte by byte: damage, order, content, gaps, clocks; exit status 1 if not",
       [](const auto& a) { return bag_check(a.path, a.json); });
  verb("recover", "Saves what can be saved of a damaged MCAP file; exit status 1 if something is lost",
       [](const auto& a) { return bag_recover(a.path, a.out, a.json); })
      ->add_option("OUT", arguments->out, "New .mcap file")
      ->required();
  CLI::App* convert =
      verb("convert", "Writes it again, as MCAP; exit status 1 if something could not be read",
           [](const auto& a) { return bag_convert(a.path, a.out, a.compression, a.json); });
  convert->add_option("OUT", arguments->out, "New .mcap file, or a folder")->required();
  convert->add_option("--compression", arguments->compression, "zstd, lz4 or none")
      ->check(CLI::IsMember({"zstd", "lz4", "none"}));
  add_bag_import(*bag);
  return bag;
}

}  // namespace

BW_VERB(look, "bag", add_bag)

}  // namespace bw::cli
