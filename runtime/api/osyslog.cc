// The console output of objects: osyslog() and osysprint(), with the meaning that printf formats
// have on the robot.
#include <OPENR/OSyslog.h>

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>

#include "runtime/core/api.h"
#include "runtime/core/printed_numbers.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

// Converts `format` from the robot's meaning to the host's: removes the 'l' before an integer
// conversion, except in "ll".  On the robot long has 32 bits, so programs print 32-bit values with
// "%ld", which would read 64 bits on this host.
std::string HostFormat(const char* format) {
  std::string result;
  for (const char* p = format; *p != '\0';) {
    if (*p != '%') {
      result += *p++;
      continue;
    }
    result += *p++;
    while (*p != '\0' && std::strchr("-+ #0123456789.*", *p) != nullptr) result += *p++;
    if (*p == 'l' && p[1] != '\0' && std::strchr("diouxX", p[1]) != nullptr) ++p;
    if (*p == 'l' && p[1] == 'l') {
      result += *p++;
      result += *p++;
    }
    if (*p != '\0') result += *p++;
  }
  return result;
}

std::string Format(const char* format, va_list arguments) {
  const std::string host_format = HostFormat(format);
  ReportPrintedNaN(host_format.c_str(), arguments);
  char text[osyslogMAX_SIZE];
  vsnprintf(text, sizeof text, host_format.c_str(), arguments);
  return text;
}

// Stores the state that an object reports with a message of level info that begins with "state: ".
// The panel shows this state.  `openr explore` can check properties of a run that depend on this
// state.
void NoteState(openr_host::Object* object, OSyslogPriority priority, const std::string& text) {
  constexpr char kPrefix[] = "state: ";
  if (priority != osyslogINFO || object == nullptr || !text.starts_with(kPrefix)) return;
  object->statistics().set_state(text.substr(sizeof kPrefix - 1));
}

}  // namespace

OStatus osyslog(OSyslogPriority priority, const char* format, ...) {
  const ApiScope scope;
  va_list arguments;
  va_start(arguments, format);
  const std::string text = Format(format, arguments);
  va_end(arguments);
  System* const system = t_current.system;
  openr_host::Object* const object = t_current.object;
  NoteState(object, priority, text);
  if (system == nullptr) return oFAIL;
  // Does not print a message whose priority number is above the user's log level.  Debug messages,
  // whose priorities are the largest numbers, are always printed.
  if (priority > system->options().log_level && priority <= osyslogINFO) return oSUCCESS;
  char line[osyslogMAX_SIZE + 40];
  std::snprintf(line, sizeof line, "[oid:%08x,prio:%d] %s%s",
                object == nullptr ? 0u : static_cast<unsigned>(OidValue(object->id)),
                static_cast<int>(priority), text.c_str(),
                priority == osyslogDEBUG_NO_NEWLINE ? "" : "\n");
  system->Print(line);
  return oSUCCESS;
}

OStatus osysprint(const char* format, ...) {
  const ApiScope scope;
  va_list arguments;
  va_start(arguments, format);
  const std::string text = Format(format, arguments);
  va_end(arguments);
  if (t_current.system == nullptr) return oFAIL;
  t_current.system->Print(text);
  return oSUCCESS;
}
