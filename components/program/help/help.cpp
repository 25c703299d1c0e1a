// bandwagon help [TOPIC]: the project's own pages, as the page's "?" shows them.
#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "components/viewer/adaptor/help/help_pages.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/remote/web/content_coding.hpp"

namespace bw {
namespace {

void list_topics() {
  std::cout << "bandwagon help TOPIC prints a page; bandwagon VERB --help the options of a verb.\n";
  std::string_view group;
  for (const viewer::HelpPage& page : viewer::help_pages().subspan(1)) {
    if (page.group != group) std::cout << fmt::format("\n{}:\n", page.group);
    group = page.group;
    std::cout << fmt::format("  {:<24} {}\n", page.topic, page.tells);
  }
}

/// Topics that hold `text`, or that it holds: what somebody may have meant.
std::string near_topics(std::string_view text) {
  std::string near;
  for (const viewer::HelpPage& page : viewer::help_pages().subspan(1)) {
    if (page.topic.find(text) == std::string_view::npos && page.tells.find(text) == std::string_view::npos &&
        text.find(page.topic) == std::string_view::npos)
      continue;
    near += fmt::format("{}{}", near.empty() ? "" : ", ", page.topic);
  }
  return near.empty() ? "`bandwagon help` lists the topics" : "one of these? " + near;
}

void help(const std::string& topic) {
  if (topic.empty()) return list_topics();
  const auto page = std::ranges::find(viewer::help_pages(), topic, &viewer::HelpPage::topic);
  if (page == viewer::help_pages().end())
    throw std::runtime_error(fmt::format("help: no topic {}; {}", topic, near_topics(topic)));
  std::cout << web::inflated(page->gzip);
}

void add_help(cli::Verb verb) {
  auto topic = std::make_shared<std::string>();
  verb.option("TOPIC", *topic, "One of those that are listed without it");
  verb.run([topic] { help(*topic); });
}

}  // namespace

BW_VERB(look, "help", "The project's pages: components, theory, robots, tutorials", add_help)

}  // namespace bw
