// LazyLibrary: a shared library that is loaded when the program first needs it, and not with the
// program.  Loading libraries takes a good part of a program's start, and most runs need only few
// of them (docs/performance.md, "The start of a run").
#pragma once

#include <string>

namespace openr_host {

class LazyLibrary {
 public:
  // Loads the library `file`, which stays loaded.  An error names `what`, such as "Cyclone DDS, by
  // which processes exchange data", and the Debian package `package`.  With `is_global`, libraries
  // that are loaded later can use the functions of this library.  Throws std::runtime_error if the
  // library cannot be loaded.
  LazyLibrary(const char* file, const char* what, const char* package, bool is_global = false);

  // Sets `*function` to the function `name`.  Throws std::runtime_error if the library has no such
  // function.
  template <typename T>
  void Find(T** function, const char* name) const {
    *function = reinterpret_cast<T*>(Address(name));
  }

 private:
  void* Address(const char* name) const;

  const std::string file_;
  void* const handle_;
};

}  // namespace openr_host
