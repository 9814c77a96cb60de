// Runs other programs, such as compilers, make and dot, and waits for their end.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

struct ProcessOptions {
  // Environment variables to set for the child, as name and value; an empty value removes the name.
  std::vector<std::pair<std::string, std::string>> environment = {};
  // Working folder of the child; "": the working folder of this process.
  std::string folder = {};
  bool captures_error = false;  // the child's standard error goes to ProcessResult::output
  bool captures_out = false;    // the child's standard output goes to ProcessResult::output
  bool echoes = false;          // captured text is also written to our standard error at once
  bool has_no_input = false;    // standard input of the child is empty
  // A function that is called about every 200 ms while RunProcess() waits for captured output of
  // the child; may be null.
  std::function<void()> while_waiting = {};
  // Text for the standard input of the child.  RunProcess() reads output of the child only after it
  // has written the whole text.  So the child must read the whole text before it writes more than a
  // pipe holds (64 KiB); otherwise both would wait for ever.
  std::optional<std::string> input = {};
};

struct ProcessResult {
  int status = -1;          // exit status; 128 + n after signal n; 127: the program did not start
  std::string output;       // text that the child wrote to captured streams
  std::string start_error;  // reason why the program was not started; "" if it was started
  bool good() const { return status == 0; }
};

// Runs a program and waits for its end.  `arguments` begins with the program, which is looked for
// in PATH.
// REQUIRES: `arguments` is not empty; `input` and `has_no_input` are not both given.
ProcessResult RunProcess(const std::vector<std::string>& arguments,
                         const ProcessOptions& options = {});

// Returns whether PATH leads to a program called `name`.
bool HasProgram(const std::string& name);

}  // namespace openr_host
