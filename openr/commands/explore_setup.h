// Prepares the runs of openr explore, both when it explores and when it replays a failing run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "openr/explore/explorer.h"
#include "openr/explore/schedule_file.h"

namespace openr_host {

// The file to which the objects of all runs print.  All processes of the exploration write to this
// file.  Without a file, the output is discarded.
class SharedConsole {
 public:
  // Opens `file` for the output of objects; "" means that the output is discarded.  Throws
  // std::runtime_error when the file cannot be written.
  explicit SharedConsole(const std::string& file);
  ~SharedConsole();
  SharedConsole(const SharedConsole&) = delete;
  SharedConsole& operator=(const SharedConsole&) = delete;

  void Print(std::string_view text) const;

  // Returns "FILE: cannot be written: reason" if a write has failed in this process or in a child
  // process; else "".  A child process stores its error in `error_`, which points to memory that
  // all these processes share.
  std::string Problem() const;

 private:
  const std::string file_;
  int descriptor_ = -1;
  int* error_ = nullptr;  // errno of the first failed write; shared by all processes
};

// Returns `exit_code`; if the output of the objects could not be written to its file, prints an
// error and returns 1 instead.
int WithConsole(int exit_code, const SharedConsole& console);

// Starts this program again with the library of AddressSanitizer if images of a stick need this
// library, because it must be loaded before the program.
void StartWithSanitizersOf(const SimulationOptions& simulation);

// Sets the members of `plan` that depend on `stick`: the length of the runs, the properties and the
// function that prepares a run.  The objects of the runs print to `console`, which must outlive
// `plan`.
void SetStick(const ExploredStick& stick, const SharedConsole& console, ExplorePlan* plan);

// Prints `text` on standard output; with `as_json`, prints `result` there, and `text` on standard
// error.
void PrintResult(const nlohmann::ordered_json& result, const std::string& text, bool as_json);

}  // namespace openr_host
