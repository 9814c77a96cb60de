// Functions of the C library that keep a state from call to call: drand48() and its kin, and
// strtok().
//
// On the robot every object has a C library of its own.  Here one C library is shared, so an object
// would get other numbers and other words if another object, or another robot, called the function
// in between.  So every object has a state of its own (LibraryState).
#include <stdlib.h>
#include <string.h>

#include "runtime/core/library_state.h"
#include "runtime/hooks/hook.h"

namespace {

using openr_host::InObject;

openr_host::LibraryState& StateOfObject() { return openr_host::t_current.object->library_state(); }

uint64_t NextRandom48() { return StateOfObject().random48.Next(); }

// Returns the number of 48 bits in `parts`, lowest 16 bits first.
uint64_t Joined(const unsigned short parts[3]) {
  return uint64_t{parts[2]} << 32 | uint64_t{parts[1]} << 16 | parts[0];
}

}  // namespace

extern "C" {

double drand48() noexcept {
  static const auto next = OPENR_NEXT(drand48);
  constexpr double kTwoTo48 = 281'474'976'710'656.0;
  return InObject() ? static_cast<double>(NextRandom48()) / kTwoTo48 : next();
}

long lrand48() noexcept {
  static const auto next = OPENR_NEXT(lrand48);
  return InObject() ? static_cast<long>(NextRandom48() >> 17) : next();
}

long mrand48() noexcept {
  static const auto next = OPENR_NEXT(mrand48);
  return InObject() ? static_cast<int32_t>(NextRandom48() >> 16) : next();
}

void srand48(long seed) noexcept {
  static const auto next = OPENR_NEXT(srand48);
  if (!InObject()) return next(seed);
  StateOfObject().random48.Seed(static_cast<uint32_t>(seed));
}

unsigned short* seed48(unsigned short state[3]) noexcept {
  static const auto next = OPENR_NEXT(seed48);
  if (!InObject()) return next(state);
  openr_host::LibraryState& own = StateOfObject();
  const uint64_t former = own.random48.state();
  own.random48.Begin(Joined(state));
  for (int i = 0; i < 3; ++i) own.former_random48[i] = static_cast<uint16_t>(former >> 16 * i);
  return own.former_random48;
}

void lcong48(unsigned short parameters[7]) noexcept {
  static const auto next = OPENR_NEXT(lcong48);
  if (!InObject()) return next(parameters);
  StateOfObject().random48.Begin(Joined(parameters), Joined(parameters + 3), parameters[6]);
}

// On the robot, strtok(nullptr, ...) without a text before it returns null.
char* strtok(char* text, const char* delimiters) noexcept {
  static const auto next = OPENR_NEXT(strtok);
  if (!InObject()) return next(text, delimiters);
  char** const place = &StateOfObject().strtok_place;
  if (text == nullptr && *place == nullptr) return nullptr;
  return strtok_r(text, delimiters, place);
}

}  // extern "C"
