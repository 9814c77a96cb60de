// Reports faults at which the robot's processor stops, and the host's mostly does not: unaligned
// access, division by zero, numbers too large for an integer (core.md 8.2, field-notes.md 4).
// Checks for these faults are compiled into images, the programs of the robot
// (cmake/compile-flags.txt).
//
// When a check fails, the code that the compiler inserted calls a function of
// UndefinedBehaviorSanitizer's runtime.  This file defines these functions, so their names and
// arguments are those of LLVM (lib/ubsan/ubsan_handlers.h of compiler-rt).  Code of the host does
// not call them: it has no checks, or, in a build with sanitizers, its checks call other functions
// (-fno-sanitize-recover).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/core/robot_fault.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

struct SourcePlace {
  const char* file;
  uint32_t line;
  uint32_t column;  // kSaid after a fault at this place has been reported
};
constexpr uint32_t kSaid = UINT32_MAX;

struct TypeText {
  uint16_t kind;  // 0: an integer, 1: a floating-point number
  uint16_t info;  // width and sign of an integer, width of a floating-point number
  char name[1];   // the first byte of the name, which goes on behind the struct: "'int'"

  bool is_integer() const { return kind == 0; }
  bool is_signed() const { return (info & 1) != 0; }
  unsigned bits() const { return is_integer() ? 1u << (info >> 1) : info; }
};

struct AccessData {
  SourcePlace place;
  const TypeText* type;
  unsigned char log_alignment;
  unsigned char kind;
};

struct ArithmeticData {
  SourcePlace place;
  const TypeText* type;
};

struct CastData {
  SourcePlace place;
  const TypeText* from;
  const TypeText* to;
};

std::string Render(const SourcePlace& place) {
  const std::string_view file = place.file == nullptr ? "?" : place.file;
  return fmt::format("{}:{}", file.substr(file.rfind('/') + 1), place.line);
}

// Reports the fault `what` of the running object; `exception` is the exception of the robot's
// processor ("exception 15").  With --strict the object crashes.  Otherwise a finding is added,
// once for each place in the source.
void Report(SourcePlace* place, const std::string& what, const char* exception) {
  if (t_current.system == nullptr || t_current.object == nullptr) return;  // no object is running
  if (t_current.system->options().strict)
    StopAsTheRobotDoes(fmt::format("{} at {} ({})", what, Render(*place), exception));
  if (std::exchange(place->column, kSaid) == kSaid) return;
  const ApiScope scope;
  t_current.system->AddFinding(Severity::kWarning, fmt::format("{} at {}: {}, the robot powers off",
                                                               what, Render(*place), exception));
}

// Returns the alignment that the robot's processor needs for the memory access `data`.  On the
// robot pointers and long have 4 bytes.  So a type that is aligned to 8 on the host is aligned to 4
// on the robot.  Only double and long long are aligned to 8 on both.
uintptr_t RobotAlignment(const AccessData& data) {
  const uintptr_t alignment = uintptr_t{1} << std::min<unsigned>(data.log_alignment, 3);
  if (alignment < 8) return alignment;
  const bool is_wide =
      data.type->kind == 1 ||
      std::strstr(static_cast<const char*>(data.type->name), "long long") != nullptr;
  return is_wide ? 8 : 4;
}

// Returns the number in the argument `value` of a check.  The argument holds the bits of a float or
// double, or the address of a long double.
double ValueOf(const TypeText& type, uintptr_t value) {
  if (type.bits() == 32) {
    const auto bits = static_cast<uint32_t>(value);
    float number = 0;
    std::memcpy(&number, &bits, sizeof number);
    return static_cast<double>(number);
  }
  double number = 0;
  if (type.bits() == 64) {
    std::memcpy(&number, &value, sizeof number);
  } else {
    number = static_cast<double>(*reinterpret_cast<const long double*>(value));
  }
  return number;
}

// Returns whether the robot's processor stops at the conversion of `number` to an integer.  The
// processor converts to 32 bits first, even to a smaller type, and even a negative number to an
// unsigned type.  A conversion to long long is different: a library function does it, which stops
// only for NaN.
bool TrapsOnTheRobot(const CastData& data, double number) {
  const TypeText& to = *data.to;
  const bool is_long_long =
      to.bits() > 32 && std::strstr(static_cast<const char*>(to.name), "long long") != nullptr;
  if (std::isnan(number)) return true;
  if (is_long_long) return false;
  const double limit = to.bits() >= 32 && !to.is_signed() ? 4294967296.0 : 2147483648.0;
  return !(number > -2147483649.0 && number < limit);
}

}  // namespace
}  // namespace openr_host

using namespace openr_host;

extern "C" {

void __ubsan_handle_type_mismatch_v1(AccessData* data, uintptr_t address) {
  const uintptr_t alignment = RobotAlignment(*data);
  if (address % alignment == 0) return;
  Report(&data->place,
         fmt::format("unaligned access to {}, whose address has to be a multiple of {},",
                     static_cast<const char*>(data->type->name), alignment),
         "exception 4 or 5");
}

// Reports an integer division by zero.  Stops the object even without --strict, because the host's
// processor would also stop at this division.
void __ubsan_handle_divrem_overflow(ArithmeticData* data, uintptr_t, uintptr_t divisor) {
  const bool is_zero = data->type->bits() <= 64 ? divisor == 0 : false;
  if (!is_zero || t_current.object == nullptr) return;
  StopAsTheRobotDoes(fmt::format("a division by zero at {} (exception 9)", Render(data->place)));
}

void __ubsan_handle_float_cast_overflow(CastData* data, uintptr_t value) {
  const double number = ValueOf(*data->from, value);
  if (!TrapsOnTheRobot(*data, number)) return;
  if (t_current.object != nullptr) t_current.object->has_reported_cast = true;
  Report(&data->place,
         fmt::format("conversion of {} to {}, which does not hold it,", number,
                     static_cast<const char*>(data->to->name)),
         "exception 15");
}

void __ubsan_handle_builtin_unreachable(const SourcePlace* place) {
  StopAsTheRobotDoes(fmt::format("code that cannot be reached was, at {}", Render(*place)));
}

}  // extern "C"
