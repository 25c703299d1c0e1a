#include "runtime/host/terminal.hpp"

#include <memory>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace bw {

void write_to_terminal(LogLevel level, const std::string& text) {
  static const std::shared_ptr<spdlog::logger> kLogger = [] {
    auto logger = spdlog::stderr_color_mt("bandwagon");
    logger->set_pattern("%^%L%$ %v");
    return logger;
  }();
  kLogger->log(static_cast<spdlog::level::level_enum>(static_cast<int>(level) / 10), text);
}

}  // namespace bw
