// Finds NaNs that an object prints.  The robot stops at them, and this processor does not: it takes
// a NaN for a number like any other.
#pragma once

#include <cstdarg>

namespace openr_host {

// Returns whether `arguments`, those of a printf with `format`, have a NaN among the numbers that
// are printed.  Leaves `arguments` as they are.  Returns false for a format that numbers its
// arguments ("%1$d"), or has a conversion that is not known.
bool PrintsNaN(const char* format, va_list arguments);

// Reports a NaN among the numbers that the running object prints: a warning, once for each place in
// its source.  With --strict the object crashes, as on the robot (field-notes.md, 4.4).
void ReportPrintedNaN(const char* format, va_list arguments);

}  // namespace openr_host
