// Ends the run if a handler does not return after Ctrl-C has come twice.  Without this, a handler
// that waits for ever, and so uses no processor time, could be ended only without a report.
#pragma once

namespace openr_host {

// Called in a signal handler when Ctrl-C or a similar signal comes a second time.  From now on a
// handler, or the loading of an image, that runs for 1 s more ends the process.  The end is
// reported as the class Watchdog reports an end, with EndKind::kSignal.  Does nothing if the end of
// the process has already begun.  Only handlers on the main thread are ended.
void StartInterruptLimit();

// Ends what StartInterruptLimit() has started, if it was called.
void StopInterruptLimit();

}  // namespace openr_host
