#include "runtime/cli/page_writer.hpp"

#include <optional>
#include <stdexcept>

namespace bw::cli {
namespace {

std::optional<PageWriter>& the_writer() {
  static std::optional<PageWriter> writer;
  return writer;
}

}  // namespace

void set_page_writer(const PageWriter& writer) { the_writer() = writer; }

const PageWriter& page_writer() {
  if (!the_writer()) throw std::runtime_error("--html: this program makes no pages");
  return *the_writer();
}

}  // namespace bw::cli
