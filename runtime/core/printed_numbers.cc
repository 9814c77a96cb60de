#include "runtime/core/printed_numbers.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "runtime/core/code_place.h"
#include "runtime/core/robot_fault.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Returns whether `number` is a NaN.  Compares bits, because an operation on a signaling NaN would
// set a flag of the processor, and the runtime would report this flag as a fault of the object.
bool IsNaNOfBits(double number) {
  uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return (bits & 0x7fffffffffffffff) > 0x7ff0000000000000;
}

bool IsOneOf(char c, const char* set) { return c != '\0' && std::strchr(set, c) != nullptr; }

// A conversion of a printf format: "%-5.*ld" has the length "l" and the type 'd'.
struct Conversion {
  int stars = 0;  // number of '*': widths and precisions that are arguments of the printf()
  std::string_view length;
  char type = '\0';
};

// Reads the conversion that begins at `*at`, behind a '%' of a printf format, and moves `*at`
// behind it.  The type is '\0' if the format ends before the type.
Conversion ReadConversion(const char** at) {
  Conversion conversion;
  const char* p = *at;
  for (; IsOneOf(*p, "-+ #'0123456789.*"); ++p) conversion.stars += *p == '*';
  const char* const length = p;
  while (IsOneOf(*p, "hlqLjzt")) ++p;
  conversion.length = {length, static_cast<size_t>(p - length)};
  conversion.type = *p;
  *at = *p == '\0' ? p : p + 1;
  return conversion;
}

// Holds the list of arguments of a printf(), so that functions can take a pointer to it.  On some
// processors a va_list is an array, so the address of a va_list parameter cannot be passed on.
struct Arguments {
  va_list list;
};

// Reads from `arguments` the argument that `conversion` prints.  Sets `*is_nan` if the argument is
// a NaN.  Returns false if the type of the argument is not known.
bool ReadArgument(const Conversion& conversion, Arguments* arguments, bool* is_nan) {
  const std::string_view length = conversion.length;
  if (IsOneOf(conversion.type, "diouxXc")) {
    if (length == "ll" || length == "q" || length == "j" || length == "L") {
      va_arg(arguments->list, long long);
    } else if (length == "l" || length == "z" || length == "t") {
      va_arg(arguments->list, long);
    } else {
      va_arg(arguments->list, int);
    }
  } else if (IsOneOf(conversion.type, "eEfFgGaA")) {
    *is_nan = IsNaNOfBits(length == "L" ? static_cast<double>(va_arg(arguments->list, long double))
                                        : va_arg(arguments->list, double));
  } else if (IsOneOf(conversion.type, "spn")) {
    va_arg(arguments->list, void*);
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool PrintsNaN(const char* format, va_list arguments) {
  Arguments copy;
  va_copy(copy.list, arguments);
  bool is_nan = false;
  for (const char* at = std::strchr(format, '%'); at != nullptr && !is_nan;
       at = std::strchr(at, '%')) {
    ++at;
    const Conversion conversion = ReadConversion(&at);
    for (int i = 0; i < conversion.stars; ++i) va_arg(copy.list, int);
    if (conversion.type == '%' || conversion.type == 'm') continue;
    if (!ReadArgument(conversion, &copy, &is_nan)) break;
  }
  va_end(copy.list);
  return is_nan;
}

void ReportPrintedNaN(const char* format, va_list arguments) {
  if (t_current.system == nullptr || t_current.object == nullptr) return;
  if (!PrintsNaN(format, arguments)) return;
  if (t_current.system->options().strict) {
    std::string what;
    {
      const ApiScope scope;
      what = fmt::format("a NaN was printed{} (exception 15)", AtCaller());
    }
    // StopAsTheRobotDoes() crashes, as the robot does at a NaN.  This crash must count as a crash
    // of the object's code.  So sets Current::image_code again, which the ApiScope in the SDK's
    // function osysprint() has cleared.
    t_current.image_code = true;
    StopAsTheRobotDoes(what);
  }
  const ApiScope scope;
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("{}a NaN was printed{}: the robot stops when a NaN is used, in printf() too: "
                  "exception 15, the robot powers off",
                  InHandler(), AtCaller()));
}

}  // namespace openr_host
