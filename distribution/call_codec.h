// Converts calls that a worker makes to functions of the master.  The arguments of a call are
// converted to data, which is sent to the master and converted back there.  The result and the
// output parameters are sent back to the worker in the same way.
//
// The type of a parameter decides how it is converted:
//   integers, enumerations, bool   a number
//   std::string_view, const char*  the text; at most one in a call
//   const std::string&             the bytes; at most one in a call
//   const T&                       the bytes of a struct without pointers
//   word*, const word*             six numbers: the gains of a joint
//   T*, std::string*               an output parameter: a number, or the bytes
// Missing or wrong data, which only a faulty worker sends, become zeros and empty texts.
#pragma once

#include <OPENR/OPENR.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/core/api.h"
#include "runtime/core/run_end.h"
#include "runtime/core/time_events.h"

namespace openr_host {

// The arguments of a call from the worker to the master, as data: numbers, a text and bytes.  The
// rules at the beginning of this file say which argument becomes what.
struct CallArguments {
  std::vector<uint64_t> numbers = {};
  std::string text = {};
  std::string bytes = {};
};

// The result of a call (`status`) and the values of its output parameters (`numbers`, `bytes`).
struct CallResult {
  int64_t status = 0;
  std::vector<uint64_t> numbers = {};
  std::string bytes = {};

  uint64_t number(size_t i) const { return i < numbers.size() ? numbers[i] : 0; }
};

namespace call_codec {

constexpr size_t kGains = 6;

template <typename T>
constexpr bool kIsNumber = std::is_integral_v<T> || std::is_enum_v<T>;

template <typename T>
std::string BytesOf(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <typename T>
void CopyBytes(const std::string& bytes, T* value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() == sizeof(T)) std::memcpy(static_cast<void*>(value), bytes.data(), sizeof(T));
}

// Reads the numbers of a call's arguments or results one after the other.  A faulty worker may send
// too few numbers, so Next() returns 0 after the last number.
class NumberReader {
 public:
  explicit NumberReader(const std::vector<uint64_t>& numbers) : numbers_(numbers) {}
  uint64_t Next() { return next_ < numbers_.size() ? numbers_[next_++] : 0; }

 private:
  const std::vector<uint64_t>& numbers_;
  size_t next_ = 0;
};

// Converts a parameter of type T of a call to the data of a CallArguments or CallResult, and back.
// The calling process uses Put() and ReadResult(); the called process uses the constructor,
// argument() and PutResult().
template <typename T>
struct Parameter {
  static_assert(kIsNumber<T>, "the codec does not know this type of parameter");
  static void Put(T value, CallArguments* to) {
    to->numbers.push_back(static_cast<uint64_t>(value));
  }
  static void ReadResult(T, const CallResult&, NumberReader*) {}

  Parameter(const CallArguments&, NumberReader* numbers) : value(static_cast<T>(numbers->Next())) {}
  T argument() { return value; }
  void PutResult(CallResult*) const {}

  T value;
};

// The base class of Parameter for parameters that pass no value back to the caller.
struct InputParameter {
  template <typename T>
  static void ReadResult(const T&, const CallResult&, NumberReader*) {}
  void PutResult(CallResult*) const {}
};

template <>
struct Parameter<std::string_view> : InputParameter {
  static void Put(std::string_view value, CallArguments* to) { to->text = value; }
  Parameter(const CallArguments& from, NumberReader*) : value(from.text) {}
  std::string_view argument() const { return value; }

  std::string_view value;
};

template <>
struct Parameter<const char*> : InputParameter {
  static void Put(const char* value, CallArguments* to) { to->text = value; }
  Parameter(const CallArguments& from, NumberReader*) : value(from.text.c_str()) {}
  const char* argument() const { return value; }

  const char* value;
};

template <>
struct Parameter<const std::string&> : InputParameter {
  static void Put(const std::string& value, CallArguments* to) { to->bytes = value; }
  Parameter(const CallArguments& from, NumberReader*) : value(from.bytes) {}
  const std::string& argument() const { return value; }

  const std::string& value;
};

template <typename T>
struct Parameter<const T&> : InputParameter {
  static void Put(const T& value, CallArguments* to) { to->bytes = BytesOf(value); }
  Parameter(const CallArguments& from, NumberReader*) { CopyBytes(from.bytes, &value); }
  const T& argument() const { return value; }

  T value{};
};

template <>
struct Parameter<const OServiceEntry&> : InputParameter {
  static void Put(const OServiceEntry& value, CallArguments* to) {
    to->numbers.push_back(static_cast<uint64_t>(ObjectIdOf(value.GetOID())));
    to->numbers.push_back(value.GetSelector());
  }
  Parameter(const CallArguments&, NumberReader* numbers) {
    const OID object = OidOf(static_cast<ObjectId>(numbers->Next()));
    value = OServiceEntry(object, static_cast<Selector>(numbers->Next()));
  }
  const OServiceEntry& argument() const { return value; }

  OServiceEntry value;
};

template <>
struct Parameter<const RunEnd&> : InputParameter {
  static void Put(const RunEnd& value, CallArguments* to) {
    to->numbers.push_back(static_cast<uint64_t>(value.kind));
    to->text = value.why;
  }
  Parameter(const CallArguments& from, NumberReader* numbers) {
    value = {static_cast<EndKind>(std::min<uint64_t>(numbers->Next(), kEndKinds)), from.text};
  }
  const RunEnd& argument() const { return value; }

  RunEnd value;
};

// Converts a TimeEvents::EventMessage, the message that TimeEvents posts at a certain time or when
// a reply arrives.  The member `owner` is not sent, because it is the calling object, which the
// master knows.
template <>
struct Parameter<const TimeEvents::EventMessage&> : InputParameter {
  static void Put(const TimeEvents::EventMessage& value, CallArguments* to) {
    to->numbers.push_back(static_cast<uint64_t>(value.target));
    to->numbers.push_back(value.selector);
    to->bytes.assign(value.bytes.begin(), value.bytes.end());
  }
  Parameter(const CallArguments& from, NumberReader* numbers) {
    value.target = static_cast<ObjectId>(numbers->Next());
    value.selector = static_cast<uint32_t>(numbers->Next());
    const size_t size = std::min(from.bytes.size(), Message::kPayloadMax);
    value.bytes.assign(from.bytes.begin(), from.bytes.begin() + static_cast<ptrdiff_t>(size));
  }
  const TimeEvents::EventMessage& argument() const { return value; }

  TimeEvents::EventMessage value;
};

template <>
struct Parameter<const word*> : InputParameter {
  static void Put(const word* value, CallArguments* to) {
    to->numbers.insert(to->numbers.end(), value, value + kGains);
  }
  Parameter(const CallArguments&, NumberReader* numbers) {
    for (word& gain : gains) gain = static_cast<word>(numbers->Next());
  }
  const word* argument() const { return gains; }

  word gains[kGains];
};

template <>
struct Parameter<word*> {
  static void Put(word*, CallArguments*) {}
  static void ReadResult(word* to, const CallResult&, NumberReader* numbers) {
    for (size_t i = 0; i < kGains; ++i) to[i] = static_cast<word>(numbers->Next());
  }
  Parameter(const CallArguments&, NumberReader*) {}
  word* argument() { return gains; }
  void PutResult(CallResult* to) const {
    to->numbers.insert(to->numbers.end(), gains, gains + kGains);
  }

  word gains[kGains] = {};
};

template <>
struct Parameter<std::string*> {
  static void Put(std::string*, CallArguments*) {}
  static void ReadResult(std::string* to, const CallResult& from, NumberReader*) {
    *to = from.bytes;
  }
  Parameter(const CallArguments&, NumberReader*) {}
  std::string* argument() { return &value; }
  void PutResult(CallResult* to) const { to->bytes = value; }

  std::string value;
};

template <typename T>
struct Parameter<T*> {
  static void Put(T*, CallArguments*) {}
  static void ReadResult(T* to, const CallResult& from, NumberReader* numbers) {
    if constexpr (kIsNumber<T>) {
      *to = static_cast<T>(numbers->Next());
    } else {
      CopyBytes(from.bytes, to);
    }
  }
  Parameter(const CallArguments&, NumberReader*) {
    // Clears the struct together with its padding.  All bytes of the struct are sent to the other
    // process, so they must not contain old memory of this process.
    std::memset(static_cast<void*>(&value), 0, sizeof value);
  }
  T* argument() { return &value; }
  void PutResult(CallResult* to) const {
    if constexpr (kIsNumber<T>) {
      to->numbers.push_back(static_cast<uint64_t>(value));
    } else {
      to->bytes = BytesOf(value);
    }
  }

  T value;
};

// Converts a call of a member function of type Function: the arguments to CallArguments and back,
// the result to CallResult and back.  The type gives the class of the function, its parameters and
// its result.
template <typename Function>
struct Signature;
template <typename Result_, typename Class_, typename... Parameters>
struct Signature<Result_ (Class_::*)(Parameters...)> {
  using Result = Result_;
  using Class = Class_;

  template <typename... Arguments>
  static CallArguments Encode(const Arguments&... arguments) {
    CallArguments encoded;
    (Parameter<Parameters>::Put(arguments, &encoded), ...);
    return encoded;
  }

  // Copies the output parameters in `result` to the places to which `arguments` point, and returns
  // the function's result.
  template <typename... Arguments>
  static Result Decode(const CallResult& result, const Arguments&... arguments) {
    NumberReader numbers(result.numbers);
    (Parameter<Parameters>::ReadResult(arguments, result, &numbers), ...);
    if constexpr (!std::is_void_v<Result>) return static_cast<Result>(result.status);
  }

  // Calls `function` of `target` with the decoded `arguments`, and returns its encoded result.
  static CallResult Call(Result (Class::*function)(Parameters...), Class* target,
                         const CallArguments& arguments) {
    NumberReader numbers(arguments.numbers);
    // Uses braces, because they construct the parameters from left to right, in the order in which
    // the numbers were encoded.
    std::tuple<Parameter<Parameters>...> parameters{Parameter<Parameters>(arguments, &numbers)...};
    CallResult result;
    std::apply(
        [&](auto&... parameter) {
          if constexpr (std::is_void_v<Result>) {
            (target->*function)(parameter.argument()...);
          } else {
            result.status = static_cast<int64_t>((target->*function)(parameter.argument()...));
          }
          (parameter.PutResult(&result), ...);
        },
        parameters);
    return result;
  }
};

}  // namespace call_codec
}  // namespace openr_host
