// Ctrl-C, SIGTERM and a terminal that is closed, as a question a loop can ask.
#pragma once

namespace bw::cli {

/// From now on SIGINT, SIGTERM and, unless it is ignored (nohup), SIGHUP no longer kill; a second one does.
void catch_interrupts();
bool interrupted();

}  // namespace bw::cli
