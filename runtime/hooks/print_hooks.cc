// Wraps printf(), sscanf() and the like for two reasons: the stack that the C library uses in these
// functions must not count as stack of the object that calls them, and a NaN that an object prints
// is reported.
//
// On this host these functions need up to 2 KiB of stack, more than all other functions that
// objects call often.  But the .ocf file of an object may allow a stack of only 3 KiB.
//
// Sanitizers define these functions themselves, so nothing is defined here in their builds.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <stdarg.h>
#include <stdio.h>

#include "runtime/core/current.h"
#include "runtime/core/printed_numbers.h"
#include "runtime/hooks/hook.h"

using openr_host::LibraryScope;
using openr_host::NextSymbol;

// Declares our version of the C library's function `plain`.  In C++ its name is OpenrV`name`,
// because <stdio.h> defines some of these functions inline, and clang accepts no second definition.
// The linker and the images know it as `plain`.
#define OPENR_LIBRARY_FUNCTION(name, plain, ...) \
  extern "C" int OpenrV##name(__VA_ARGS__, va_list arguments) __asm__(#plain)

OPENR_LIBRARY_FUNCTION(Printf, vprintf, const char* format);
OPENR_LIBRARY_FUNCTION(Fprintf, vfprintf, FILE* file, const char* format);
OPENR_LIBRARY_FUNCTION(Sprintf, vsprintf, char* text, const char* format);
OPENR_LIBRARY_FUNCTION(Snprintf, vsnprintf, char* text, size_t size, const char* format);
OPENR_LIBRARY_FUNCTION(PlainSscanf, vsscanf, const char* text, const char* format);
OPENR_LIBRARY_FUNCTION(C99Sscanf, __isoc99_vsscanf, const char* text, const char* format);

extern "C" {
int OpenrPrintf(const char* format, ...) __asm__("printf");
int OpenrFprintf(FILE* file, const char* format, ...) __asm__("fprintf");
int OpenrSprintf(char* text, const char* format, ...) __asm__("sprintf");
int OpenrSnprintf(char* text, size_t size, const char* format, ...) __asm__("snprintf");
int OpenrPlainSscanf(const char* text, const char* format, ...) __asm__("sscanf");
int OpenrC99Sscanf(const char* text, const char* format, ...) __asm__("__isoc99_sscanf");

int OpenrVPrintf(const char* format, va_list arguments) {
  return OpenrVFprintf(stdout, format, arguments);
}

int OpenrVFprintf(FILE* file, const char* format, va_list arguments) {
  static const auto next = NextSymbol<int(FILE*, const char*, va_list)>("vfprintf");
  const LibraryScope scope;
  if (openr_host::InObject()) openr_host::ReportPrintedNaN(format, arguments);
  return next(file, format, arguments);
}

int OpenrVSprintf(char* text, const char* format, va_list arguments) {
  static const auto next = NextSymbol<int(char*, const char*, va_list)>("vsprintf");
  const LibraryScope scope;
  if (openr_host::InObject()) openr_host::ReportPrintedNaN(format, arguments);
  return next(text, format, arguments);
}

int OpenrVSnprintf(char* text, size_t size, const char* format, va_list arguments) {
  static const auto next = NextSymbol<int(char*, size_t, const char*, va_list)>("vsnprintf");
  const LibraryScope scope;
  if (openr_host::InObject()) openr_host::ReportPrintedNaN(format, arguments);
  return next(text, size, format, arguments);
}

int OpenrVPlainSscanf(const char* text, const char* format, va_list arguments) {
  static const auto next = NextSymbol<int(const char*, const char*, va_list)>("vsscanf");
  const LibraryScope scope;
  return next(text, format, arguments);
}

int OpenrVC99Sscanf(const char* text, const char* format, va_list arguments) {
  static const auto next = NextSymbol<int(const char*, const char*, va_list)>("__isoc99_vsscanf");
  const LibraryScope scope;
  return next(text, format, arguments);
}

#define OPENR_WITH_ARGUMENTS(call) \
  va_list arguments;               \
  va_start(arguments, format);     \
  const int result = call;         \
  va_end(arguments);               \
  return result

int OpenrPrintf(const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVFprintf(stdout, format, arguments));
}
int OpenrFprintf(FILE* file, const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVFprintf(file, format, arguments));
}
int OpenrSprintf(char* text, const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVSprintf(text, format, arguments));
}
int OpenrSnprintf(char* text, size_t size, const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVSnprintf(text, size, format, arguments));
}
int OpenrPlainSscanf(const char* text, const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVPlainSscanf(text, format, arguments));
}
int OpenrC99Sscanf(const char* text, const char* format, ...) {
  OPENR_WITH_ARGUMENTS(OpenrVC99Sscanf(text, format, arguments));
}

}  // extern "C"

#endif
