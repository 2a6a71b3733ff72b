/// SIGINT and SIGTERM as a flag that long loops ask.
#pragma once

namespace quad_support {

/// From now on SIGINT and SIGTERM set the flag instead of ending the process; a second one ends it
/// at once.
void installInterruptHandlers();

/// @throws Interrupted if a signal has arrived. Cheap: one atomic read.
void throwIfInterrupted();

}  // namespace quad_support
