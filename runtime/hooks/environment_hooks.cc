// Functions of the C library that depend on the environment of the process: getenv(), setlocale()
// and the functions of local time.
//
// The robot has no environment, no locale but "C", and no time zone: local time is UTC.  With the
// host's settings, a run would depend on the computer and on the user.
#include <errno.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "runtime/hooks/hook.h"

namespace {

using openr_host::InObject;

// Returns whether an object may use the locale `name`.  The locale "" would be that of the
// environment, and the robot has no environment, so it is "C".
bool IsLocaleOfRobot(const char* name) {
  return *name == '\0' || strcmp(name, "C") == 0 || strcmp(name, "POSIX") == 0;
}

}  // namespace

extern "C" {

char* getenv(const char* name) noexcept {
  static const auto next = OPENR_NEXT(getenv);
  return InObject() ? nullptr : next(name);
}

// The C++ library calls this function.
char* secure_getenv(const char* name) noexcept {
  static const auto next = OPENR_NEXT(secure_getenv);
  return InObject() ? nullptr : next(name);
}

char* setlocale(int category, const char* name) noexcept {
  static const auto next = OPENR_NEXT(setlocale);
  if (!InObject()) return next(category, name);
  static char only[] = "C";
  return name == nullptr || IsLocaleOfRobot(name) ? only : nullptr;
}

locale_t newlocale(int mask, const char* name, locale_t base) noexcept {
  static const auto next = OPENR_NEXT(newlocale);
  if (!InObject() || name == nullptr) return next(mask, name, base);
  if (IsLocaleOfRobot(name)) return next(mask, "C", base);
  errno = ENOENT;
  return nullptr;
}

// std::locale of the C++ library calls newlocale() by this name.
locale_t __newlocale(int mask, const char* name, locale_t base) noexcept {
  return newlocale(mask, name, base);
}

struct tm* localtime(const time_t* time) noexcept {
  static const auto next = OPENR_NEXT(localtime);
  return InObject() ? gmtime(time) : next(time);
}

struct tm* localtime_r(const time_t* time, struct tm* result) noexcept {
  static const auto next = OPENR_NEXT(localtime_r);
  return InObject() ? gmtime_r(time, result) : next(time, result);
}

time_t mktime(struct tm* time) noexcept {
  static const auto next = OPENR_NEXT(mktime);
  return InObject() ? timegm(time) : next(time);
}

char* ctime(const time_t* time) noexcept {
  static const auto next = OPENR_NEXT(ctime);
  return InObject() ? asctime(gmtime(time)) : next(time);
}

char* ctime_r(const time_t* time, char* text) noexcept {
  static const auto next = OPENR_NEXT(ctime_r);
  if (!InObject()) return next(time, text);
  struct tm parts;
  return gmtime_r(time, &parts) == nullptr ? nullptr : asctime_r(&parts, text);
}

// Writes GMT as the name of the time zone.  A program that fills in `time` by itself gives no name,
// and the C library would take that of the host.
size_t strftime(char* text, size_t size, const char* format, const struct tm* time) noexcept {
  static const auto next = OPENR_NEXT(strftime);
  if (!InObject()) return next(text, size, format, time);
  struct tm parts = *time;
  parts.tm_gmtoff = 0;
  parts.tm_zone = "GMT";
  return next(text, size, format, &parts);
}

}  // extern "C"
