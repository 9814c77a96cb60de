// Reports faults at which the robot's processor stops, and the host's processor mostly does not:
// unaligned access, division by zero, numbers too large for an integer (core.md 8.2, field-notes.md
// 4).  Checks for these faults are compiled into images, the programs of the robot
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
  // The column of the source code at which the image checks for a fault, such as a division by
  // zero.  When a fault at this place was reported, the column is replaced by kSaid, so that each
  // place is reported only once.
  uint32_t column;
};
constexpr uint32_t kSaid = UINT32_MAX;

struct TypeText {
  uint16_t kind;  // kind of the type: 0 is an integer, 1 is a floating-point number
  uint16_t info;  // width and sign of an integer, width of a floating-point number
  char name[1];   // the type's name in quotes ("'int'"); its other bytes follow this struct

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

struct ShiftData {
  SourcePlace place;
  const TypeText* type;  // type of the number that is shifted
  const TypeText* count_type;
};

struct IndexData {
  SourcePlace place;
  const TypeText* array;
  const TypeText* index;
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
  // Does nothing if no object is current, because a fault is reported as the fault of an object.
  if (t_current.system == nullptr || t_current.object == nullptr) return;
  if (t_current.system->options().strict)
    StopAsTheRobotDoes(fmt::format("{} at {} ({})", what, Render(*place), exception));
  if (std::exchange(place->column, kSaid) == kSaid) return;
  const ApiScope scope;
  t_current.system->AddFinding(Severity::kWarning, fmt::format("{} at {}: {}, the robot powers off",
                                                               what, Render(*place), exception));
}

// Adds a finding about `what`, an operation whose result C++ does not define, once for each place
// in the source.  Only images of openr build --sanitize have checks for these operations.
void ReportUndefined(SourcePlace* place, const std::string& what) {
  if (t_current.system == nullptr || t_current.object == nullptr) return;
  if (std::exchange(place->column, kSaid) == kSaid) return;
  const ApiScope scope;
  t_current.system->AddFinding(Severity::kWarning,
                               fmt::format("undefined behaviour at {}: {}", Render(*place), what));
}

const char* NameOf(const TypeText* type) { return static_cast<const char*>(type->name); }

// Returns the text of the integer in `value`, an argument with which a check of
// UndefinedBehaviorSanitizer calls a function of this file.  For an integer of more than 64 bits
// `value` is only an address, so the text is "a number".
std::string TextOf(const TypeText& type, uintptr_t value) {
  if (!type.is_integer() || type.bits() > 64) return "a number";
  const unsigned unused = 64 - type.bits();
  if (!type.is_signed()) return std::to_string(value << unused >> unused);
  return std::to_string(static_cast<int64_t>(value << unused) >> unused);
}

void ReportOverflow(ArithmeticData* data, uintptr_t left, const char* sign, uintptr_t right) {
  ReportUndefined(&data->place,
                  fmt::format("{} {} {} is too large for {}", TextOf(*data->type, left), sign,
                              TextOf(*data->type, right), NameOf(data->type)));
}

// Reports an access to `address` that C++ does not define, because the address is null, or because
// the object at this address is smaller than the type of the access.  REQUIRES: `address` has the
// alignment that the robot needs.
void ReportAccess(AccessData* data, uintptr_t address) {
  if (address == 0) {
    ReportUndefined(&data->place, fmt::format("a null pointer is used as {}", NameOf(data->type)));
  } else if (address % (uintptr_t{1} << data->log_alignment) == 0) {
    ReportUndefined(&data->place, fmt::format("{} does not fit into the object that is accessed",
                                              NameOf(data->type)));
  }
}

// Returns the alignment that the robot's processor needs for the memory access `data`.  On the
// robot pointers and long have 4 bytes.  So a type that is aligned to 8 on the host is aligned to 4
// on the robot.  Only double and long long are aligned to 8 on the robot too.
uintptr_t RobotAlignment(const AccessData& data) {
  const uintptr_t alignment = uintptr_t{1} << std::min<unsigned>(data.log_alignment, 3);
  if (alignment < 8) return alignment;
  const bool is_wide =
      data.type->kind == 1 ||
      std::strstr(static_cast<const char*>(data.type->name), "long long") != nullptr;
  return is_wide ? 8 : 4;
}

// Returns the floating-point number in `value`, an argument with which a check of
// UndefinedBehaviorSanitizer calls a function of this file.  `value` holds the bits of a float or
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

// Returns whether the robot's processor stops when it converts `number` to an integer.  The
// processor first converts to 32 bits, so a smaller type has the limits of 32 bits, and a negative
// number fits an unsigned type.  A library function does the conversion to long long, and stops
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
  if (address % alignment == 0) return ReportAccess(data, address);
  Report(&data->place,
         fmt::format("unaligned access to {}, whose address has to be a multiple of {},",
                     static_cast<const char*>(data->type->name), alignment),
         "exception 4 or 5");
}

// Reports an integer division by zero.  Stops the object even without --strict, because the host's
// processor would also stop at this division.
void __ubsan_handle_divrem_overflow(ArithmeticData* data, uintptr_t, uintptr_t divisor) {
  // If the type has more than 64 bits, the argument `divisor` is the address of the divisor.  Then
  // does not check whether the divisor is zero.
  const bool is_zero = data->type->bits() <= 64 ? divisor == 0 : false;
  if (!is_zero || t_current.object == nullptr) return;
  StopAsTheRobotDoes(fmt::format("a division by zero at {} (exception 9)", Render(data->place)));
}

void __ubsan_handle_float_cast_overflow(CastData* data, uintptr_t value) {
  const double number = ValueOf(*data->from, value);
  if (!TrapsOnTheRobot(*data, number)) return;
  if (t_current.object != nullptr) t_current.object->number_faults().NoteReportedCast();
  Report(&data->place,
         fmt::format("conversion of {} to {}, which does not hold it,", number,
                     static_cast<const char*>(data->to->name)),
         "exception 15");
}

void __ubsan_handle_builtin_unreachable(const SourcePlace* place) {
  StopAsTheRobotDoes(fmt::format("code that cannot be reached was, at {}", Render(*place)));
}

// Only images of openr build --sanitize call this function and the functions after it.
void __ubsan_handle_add_overflow(ArithmeticData* data, uintptr_t left, uintptr_t right) {
  ReportOverflow(data, left, "+", right);
}

void __ubsan_handle_sub_overflow(ArithmeticData* data, uintptr_t left, uintptr_t right) {
  ReportOverflow(data, left, "-", right);
}

void __ubsan_handle_mul_overflow(ArithmeticData* data, uintptr_t left, uintptr_t right) {
  ReportOverflow(data, left, "*", right);
}

void __ubsan_handle_negate_overflow(ArithmeticData* data, uintptr_t value) {
  ReportUndefined(&data->place, fmt::format("-({}) is too large for {}", TextOf(*data->type, value),
                                            NameOf(data->type)));
}

void __ubsan_handle_shift_out_of_bounds(ShiftData* data, uintptr_t value, uintptr_t count) {
  ReportUndefined(&data->place, fmt::format("{}, a value of {}, is shifted by {} bits",
                                            TextOf(*data->type, value), NameOf(data->type),
                                            TextOf(*data->count_type, count)));
}

void __ubsan_handle_out_of_bounds(IndexData* data, uintptr_t index) {
  ReportUndefined(&data->place, fmt::format("index {} is outside of {}",
                                            TextOf(*data->index, index), NameOf(data->array)));
}

void __ubsan_handle_vla_bound_not_positive(ArithmeticData* data, uintptr_t bound) {
  ReportUndefined(&data->place,
                  fmt::format("an array gets {} elements", TextOf(*data->type, bound)));
}

void __ubsan_handle_load_invalid_value(ArithmeticData* data, uintptr_t value) {
  ReportUndefined(&data->place, fmt::format("{} is no value of {}; was it never set?",
                                            TextOf(*data->type, value), NameOf(data->type)));
}

void __ubsan_handle_nonnull_arg(SourcePlace* place) {
  ReportUndefined(place, "a null pointer is given to a function that takes none");
}

void __ubsan_handle_nonnull_return_v1(void*, SourcePlace* place) {
  ReportUndefined(place, "a null pointer is returned by a function that returns none");
}

void __ubsan_handle_pointer_overflow(SourcePlace* place, uintptr_t, uintptr_t) {
  ReportUndefined(place, "a pointer is moved beyond the end of the address space, or is null");
}

void __ubsan_handle_invalid_builtin(SourcePlace* place) {
  ReportUndefined(place, "zeros of the number 0 are counted");
}

}  // extern "C"
