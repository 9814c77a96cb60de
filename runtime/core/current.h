// t_current: the object whose code runs on this thread, if any, and classes that change t_current
// for a scope.
//
// The SDK's functions have no argument for the object that calls them, so they read it from
// t_current.  The dispatcher sets t_current around every handler, and the loader sets t_current
// while the constructors of an image run.
#pragma once

#include "runtime/core/arithmetic_watch.h"

namespace openr_host {

class Object;
class System;

struct Current {
  System* system = nullptr;
  Object* object = nullptr;
  // True while code of an image (a program of the robot) runs.  False while this code calls a
  // function of the runtime.  While true, malloc() takes memory from the object's heap and fopen()
  // opens files of the Memory Stick.
  bool image_code = false;
  // Finds floating-point faults of the running handler, and keeps its rounding mode; null if no
  // handler of an image runs.
  ArithmeticWatch* watch = nullptr;
};

// The object whose code runs on this thread.  The variable needs no constructor and no destructor
// at run time, so it can be used before main() and in malloc().
extern thread_local constinit Current t_current;

// While an ApiScope exists, malloc() and fopen() use the host's heap and files and not those of the
// object.  The memory and files of the runtime must not be the object's.  The first statement of
// every function of the SDK that may allocate memory or open files makes an ApiScope or calls
// InApi().
class ApiScope {
 public:
  [[gnu::always_inline]] ApiScope() : image_code_(t_current.image_code) {
    if (!image_code_) return;
    t_current.image_code = false;
    if (t_current.watch != nullptr) t_current.watch->Pause();
  }
  [[gnu::always_inline]] ~ApiScope() {
    if (!image_code_) return;
    t_current.image_code = true;
    if (t_current.watch != nullptr) t_current.watch->Resume();
  }
  ApiScope(const ApiScope&) = delete;
  ApiScope& operator=(const ApiScope&) = delete;

 private:
  const bool image_code_;
};

// Makes an ApiScope, calls `work` and returns its result.  InApi() calls this function only if code
// of an image is the caller; for other callers it saves the time that an ApiScope takes.  The
// functions of the SDK that run for every notification use InApi().
template <typename Work>
[[gnu::noinline]] auto InApiOfImage(const Work& work) {
  const ApiScope scope;
  return work();
}
template <typename Work>
[[gnu::always_inline]] inline auto InApi(const Work& work) {
  if (t_current.image_code) [[unlikely]]
    return InApiOfImage(work);
  return work();
}

// While a LibraryScope exists, floating-point operations raise no SIGFPE and round to the nearest
// number, because they are operations of the library and not of the object.  Unlike with an
// ApiScope, malloc() and fopen() still use the heap and files of the object.  The first statement
// of every function of the C library that the runtime defines makes a LibraryScope.
class LibraryScope {
 public:
  [[gnu::always_inline]] LibraryScope() : watch_(t_current.image_code ? t_current.watch : nullptr) {
    if (watch_ != nullptr) watch_->Pause();
  }
  [[gnu::always_inline]] ~LibraryScope() {
    if (watch_ != nullptr) watch_->Resume();
  }
  LibraryScope(const LibraryScope&) = delete;
  LibraryScope& operator=(const LibraryScope&) = delete;

 private:
  ArithmeticWatch* const watch_;
};

// While a CurrentScope exists, `object` of `system` is the current object.  `image_code` is true if
// code of the object's image runs in this scope (Current::image_code).
class CurrentScope {
 public:
  CurrentScope(System* system, Object* object, bool image_code = false) : saved_(t_current) {
    t_current = {system, object, image_code};
  }
  ~CurrentScope() { t_current = saved_; }
  CurrentScope(const CurrentScope&) = delete;
  CurrentScope& operator=(const CurrentScope&) = delete;

 private:
  const Current saved_;
};

}  // namespace openr_host
