// Ctrl-C and SIGTERM as a question a loop can ask.
#pragma once

namespace bw::cli {

/// From now on SIGINT and SIGTERM no longer kill; a second one does.
void catch_interrupts();
bool interrupted();

}  // namespace bw::cli
