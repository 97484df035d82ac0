#pragma once

namespace multipath {

/// From now on Ctrl-C (SIGINT) and SIGTERM ask the work to end in good order; a second one kills.
void watch_interrupts();

/// Has one been received?
bool interrupted();

} // namespace multipath
