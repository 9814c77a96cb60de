// Console output of objects.
//
// The macros of this header need double parentheses, as in OSYSPRINT(("n = %d\n", n)).  Each macro
// is an expression, or is empty if it is switched off.  The format is that of printf, except that l
// means 32 bits, as on the robot: %ld prints a slongword.  Text is cut to osyslogMAX_SIZE bytes,
// including the final NUL.
#ifndef OPENR_OSYSLOG_H_INCLUDED
#define OPENR_OSYSLOG_H_INCLUDED

#include <OPENR/OPENR.h>
#include <Types.h>
#include <stddef.h>

typedef longword OSyslogPriority;
const OSyslogPriority osyslogERROR = 1;
const OSyslogPriority osyslogWARNING = 2;
const OSyslogPriority osyslogINFO = 3;
const OSyslogPriority osyslogDEBUG = 0xffffffff;
const OSyslogPriority osyslogDEBUG_NO_NEWLINE = 0xfffffffe;

const size_t osyslogMAX_SIZE = 243;

// Prints a line such as "[oid:80000043,prio:1] text\n".
OStatus osyslog(OSyslogPriority priority, const char* format, ...);
// Prints only the text that `format` gives, without the OID of the object and the priority.
OStatus osysprint(const char* format, ...);

#define OSYSPRINT(x) (osysprint x)

#ifdef OPENR_DEBUG
#define OSYSDEBUG(x) (osysprint x)
#else
#define OSYSDEBUG(x)
#endif

#ifndef OSYSLOG_SHOW
#if defined(SYSMSGSHOW) && SYSMSGSHOW > 0
#define OSYSLOG_SHOW 4
#else
#define OSYSLOG_SHOW 1
#endif
#endif

#if OSYSLOG_SHOW >= 1
#define OSYSLOG1(x) (osyslog x)
#else
#define OSYSLOG1(x)
#endif
#if OSYSLOG_SHOW >= 2
#define OSYSLOG2(x) (osyslog x)
#else
#define OSYSLOG2(x)
#endif
#if OSYSLOG_SHOW >= 3
#define OSYSLOG3(x) (osyslog x)
#else
#define OSYSLOG3(x)
#endif
#if OSYSLOG_SHOW >= 4
#define OSYSLOG4(x) (osyslog x)
#else
#define OSYSLOG4(x)
#endif

#endif  // OPENR_OSYSLOG_H_INCLUDED
