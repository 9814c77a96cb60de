// Functions that read from the console: gets(), getchar(), scanf(), fgets(stdin), std::cin,
// read(0).
//
// Each object that calls one of these functions gets a standard input of its own.  A read waits for
// a line and stops only the object that reads; all other objects continue.  std::cin needs no
// function here, because it calls getc(), ungetc() and fread(), of which this process has its own
// versions.
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>

#include "runtime/core/system.h"
#include "runtime/core/write_errors.h"
#include "runtime/hooks/hook.h"
#include "runtime/hooks/open_file.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::LibraryScope;
using openr_host::NextSymbol;
using openr_host::Severity;
using openr_host::t_current;

namespace {

ssize_t ReadConsole(char* buffer, size_t size) {
  const ApiScope scope;
  std::fflush(stdout);  // shows a prompt that the object has printed
  if (t_current.object->running() == nullptr) {
    t_current.system->AddFinding(Severity::kError,
                                 "the console is read in a constructor: only a handler can wait "
                                 "for a line; it gets the end of the input");
    return 0;
  }
  return static_cast<ssize_t>(t_current.system->calls().ReadLine(buffer, size));
}

// Returns the current object's own standard input, which reads from the console; makes it at the
// first call.
FILE* Terminal() {
  const ApiScope scope;
  FILE*& terminal = t_current.object->files().terminal;
  if (terminal == nullptr) {
    cookie_io_functions_t functions = {};
    functions.read = [](void*, char* buffer, size_t size) { return ReadConsole(buffer, size); };
    terminal = fopencookie(nullptr, "r", functions);
  }
  return terminal;
}

// Returns `file`, or the object's own standard input if an object passes stdin.
FILE* Resolve(FILE* file) { return file == stdin && InObject() ? Terminal() : file; }

}  // namespace

extern "C" {

int getc(FILE* file) {
  static const auto next = OPENR_NEXT(getc);
  const LibraryScope scope;
  return next(Resolve(file));
}

int fgetc(FILE* file) {
  static const auto next = OPENR_NEXT(fgetc);
  const LibraryScope scope;
  return next(Resolve(file));
}

// <stdio.h> defines getchar() and getline() inline, and clang accepts no second definition of these
// functions.  So here they have other names in C++; __asm__ gives them the names getchar and
// getline in the object file.
int OpenrGetchar() __asm__("getchar");
ssize_t OpenrGetline(char** line, size_t* size, FILE* file) __asm__("getline");

int OpenrGetchar() { return getc(stdin); }

int ungetc(int c, FILE* file) {
  static const auto next = OPENR_NEXT(ungetc);
  const LibraryScope scope;
  return next(c, Resolve(file));
}

char* fgets(char* line, int size, FILE* file) {
  static const auto next = OPENR_NEXT(fgets);
  const LibraryScope scope;
  return next(line, size, Resolve(file));
}

// Reads a line without its newline.  Like every gets(), this function does not know the size of the
// buffer, so a long line overflows the buffer.
char* gets(char* line) {
  char* end = line;
  int c = getc(stdin);
  if (c == EOF) return nullptr;
  for (; c != EOF && c != '\n'; c = getc(stdin)) *end++ = static_cast<char>(c);
  *end = '\0';
  return line;
}

size_t fread(void* data, size_t size, size_t count, FILE* file) {
  static const auto next = OPENR_NEXT(fread);
  const LibraryScope scope;
  return next(data, size, count, Resolve(file));
}

// Defines the scanf() functions whose names begin with `prefix`.  The C library has two versions of
// each function, one for C99 and one for an older standard.  <stdio.h> makes a program call one or
// the other, depending on the language level of the program, so both versions are defined here.
#define OPENR_SCANF_FAMILY(tag, prefix)                                                          \
  int tag##vfscanf(FILE* file, const char* format, va_list arguments) __asm__(prefix "vfscanf"); \
  int tag##vscanf(const char* format, va_list arguments) __asm__(prefix "vscanf");               \
  int tag##fscanf(FILE* file, const char* format, ...) __asm__(prefix "fscanf");                 \
  int tag##scanf(const char* format, ...) __asm__(prefix "scanf");                               \
  int tag##vfscanf(FILE* file, const char* format, va_list arguments) {                          \
    static const auto next = NextSymbol<int(FILE*, const char*, va_list)>(prefix "vfscanf");     \
    const LibraryScope scope;                                                                    \
    return next(Resolve(file), format, arguments);                                               \
  }                                                                                              \
  int tag##vscanf(const char* format, va_list arguments) {                                       \
    return tag##vfscanf(stdin, format, arguments);                                               \
  }                                                                                              \
  int tag##fscanf(FILE* file, const char* format, ...) {                                         \
    va_list arguments;                                                                           \
    va_start(arguments, format);                                                                 \
    const int result = tag##vfscanf(file, format, arguments);                                    \
    va_end(arguments);                                                                           \
    return result;                                                                               \
  }                                                                                              \
  int tag##scanf(const char* format, ...) {                                                      \
    va_list arguments;                                                                           \
    va_start(arguments, format);                                                                 \
    const int result = tag##vfscanf(stdin, format, arguments);                                   \
    va_end(arguments);                                                                           \
    return result;                                                                               \
  }
OPENR_SCANF_FAMILY(openr_plain_, "")
OPENR_SCANF_FAMILY(openr_c99_, "__isoc99_")

ssize_t getdelim(char** line, size_t* size, int delimiter, FILE* file) {
  static const auto next = OPENR_NEXT(getdelim);
  const LibraryScope scope;
  return next(line, size, delimiter, Resolve(file));
}

ssize_t OpenrGetline(char** line, size_t* size, FILE* file) {
  return getdelim(line, size, '\n', file);
}

int feof(FILE* file) noexcept {
  static const auto next = OPENR_NEXT(feof);
  return next(Resolve(file));
}

int ferror(FILE* file) noexcept {
  static const auto next = OPENR_NEXT(ferror);
  return next(Resolve(file));
}

void clearerr(FILE* file) noexcept {
  static const auto next = OPENR_NEXT(clearerr);
  if (InObject()) openr_host::ReportErrorMark(file);
  next(Resolve(file));
}

// Reads from the console with the descriptors 0, 1 and 2, because on the robot they are the same
// terminal.
ssize_t read(int descriptor, void* data, size_t size) {
  static const auto next = OPENR_NEXT(read);
  if (!InObject()) return next(descriptor, data, size);
  if (openr_host::IsConsole(descriptor)) return ReadConsole(static_cast<char*>(data), size);
  return openr_host::RefusesDescriptor("read", descriptor) ? -1 : next(descriptor, data, size);
}

// Returns whether `descriptor` is a terminal.  Objects see the console at the descriptors 0, 1 and
// 2; all their other descriptors are files.
int isatty(int descriptor) noexcept {
  static const auto next = OPENR_NEXT(isatty);
  if (!InObject()) return next(descriptor);
  if (openr_host::IsConsole(descriptor)) return 1;
  errno = ENOTTY;
  return 0;
}

}  // extern "C"
