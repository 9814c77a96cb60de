// Finds leaks of objects: blocks of an object's heap, and regions of shared memory that it owns, to
// which nothing points any more.
//
// On the robot a leak is no mistake by itself, because the heap of an object is freed as a whole.
// But an object that loses memory with every message stops after hours.  So leaks are only looked
// for when a user asks (SystemOptions::find_leaks), and are notes of the report.
//
// A block counts as reachable if its address, or an address inside of it, is in the variables of an
// image, in another reachable block or region, on the stack of a handler that waits, or anywhere in
// the memory of the runtime.  Any number that looks like such an address has the same effect.  So a
// leak can be missed, but memory that is still used is never reported.
#pragma once

namespace openr_host {

class System;

// Adds a note for each place in the source of an object where leaked memory was allocated, or one
// note that there is no leak.  REQUIRES: SystemOptions::find_leaks.
void ReportLeaks(System* system);

}  // namespace openr_host
