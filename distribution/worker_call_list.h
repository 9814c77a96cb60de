// The functions of the master that a worker can call, by their numbers in samples.
//
// The functions of SystemCalls are listed here, and those of RobotServices in the table
// OPENR_ROBOT_CALLS; call_codec.h converts their arguments and their results.  A new function of
// SystemCalls needs a line here and a function in WorkerCalls.  The numbers are part of the
// protocol, and each new line moves the numbers after it, those of the robot's functions as well.
// So a new function and a change of the order need a new openr_wire::VERSION.
#pragma once

#include <cstdint>
#include <type_traits>

#include "distribution/call_codec.h"
#include "distribution/checked_calls.h"
#include "runtime/base/assert.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system_calls.h"

namespace openr_host {

template <auto... kFunctions>
struct CallList {
  static constexpr uint32_t kSize = sizeof...(kFunctions);

  template <auto kFunction>
  static constexpr uint32_t NumberOf() {
    uint32_t number = 0;
    const bool is_found = ((IsSame<kFunction, kFunctions>() || (++number, false)) || ...);
    return is_found ? number : throw "the function is not in the list";
  }

  // Calls function `number` of the list with `arguments`.  `target_of` returns the C++ object on
  // which the function is called.  The argument of `target_of` is a null pointer; the type of this
  // pointer tells the class of the function.  REQUIRES: number < kSize.
  template <typename TargetOf>
  static CallResult Call(uint32_t number, TargetOf&& target_of, const CallArguments& arguments) {
    ASSERT(number < kSize, "function {}", number);
    CallResult result;
    uint32_t index = 0;
    const bool is_found =
        ((index++ == number ? (result = CallOne<kFunctions>(target_of, arguments), true) : false) ||
         ...);
    ASSERT(is_found, "function {}", number);
    return result;
  }

 private:
  template <auto kFirst, auto kSecond>
  static constexpr bool IsSame() {
    return std::is_same_v<std::integral_constant<decltype(kFirst), kFirst>,
                          std::integral_constant<decltype(kSecond), kSecond>>;
  }

  template <auto kFunction, typename TargetOf>
  static CallResult CallOne(TargetOf&& target_of, const CallArguments& arguments) {
    using Function = call_codec::Signature<decltype(kFunction)>;
    return Function::Call(kFunction, target_of(static_cast<typename Function::Class*>(nullptr)),
                          arguments);
  }
};

// Makes a comma and a function from each row of OPENR_ROBOT_CALLS.  The comma comes first, because
// WorkerCallList below ends with these rows, after a function that has no comma behind it.
#define OPENR_CALL_ROBOT(name, parameters, arguments, without_devices) , &RobotServices::name
#define OPENR_CALL_WITH_MEMORY(name, parameters, arguments, without_devices) , &CheckedCalls::name

// clang-format off
using WorkerCallList = CallList<
    &SystemCalls::OpenBox, &SystemCalls::CloseBox, &SystemCalls::SetQueueMax,
    &SystemCalls::AddTimedEvent, &SystemCalls::AddReplyEvent, &SystemCalls::CancelEvent,
    &SystemCalls::CountEvents, &SystemCalls::RegisterName, &SystemCalls::FindName,
    &SystemCalls::UnregisterName, &SystemCalls::RegisterService, &SystemCalls::NameEntry,
    &SystemCalls::NewRegion, &SystemCalls::DeleteRegion, &SystemCalls::ResizeRegion,
    &SystemCalls::PinRegion, &SystemCalls::UnpinRegion, &SystemCalls::AllowAccess,
    &SystemCalls::Attach, &SystemCalls::Detach, &SystemCalls::CheckAccess,
    &SystemCalls::NoteMapping, &CheckedCalls::AddFindingAbout, &SystemCalls::Shutdown,
    &SystemCalls::PowerOff, &SystemCalls::NoteFileWritten
    OPENR_ROBOT_CALLS(OPENR_CALL_ROBOT, OPENR_CALL_WITH_MEMORY)>;
// clang-format on

#undef OPENR_CALL_ROBOT
#undef OPENR_CALL_WITH_MEMORY

}  // namespace openr_host
