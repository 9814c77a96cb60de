// Finds NaNs that an object prints.  The robot's processor stops when a program uses a NaN, also in
// printf().  The host's processor does not stop, so the runtime itself looks for NaNs in printed
// numbers.
#pragma once

#include <cstdarg>

namespace openr_host {

// Returns whether a NaN is among the numbers that a printf() with `format` and `arguments` prints.
// Leaves `arguments` as they are.  Returns false for a format that numbers its arguments ("%1$d"),
// or has a conversion that is not known.
bool PrintsNaN(const char* format, va_list arguments);

// If the running object prints a NaN, adds a warning, once for each place in its source.  With
// --strict the object crashes, as on the robot (field-notes.md, 4.4).
void ReportPrintedNaN(const char* format, va_list arguments);

}  // namespace openr_host
