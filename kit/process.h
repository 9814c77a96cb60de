// Other programs: compilers, make.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace openr_host {

struct ProcessOptions {
  // Names and values set for the child; an empty value takes the name away.
  std::vector<std::pair<std::string, std::string>> environment = {};
  std::string folder = {};      // where it runs; "": here
  bool captures_error = false;  // its standard error becomes `output` instead of ours
  bool captures_out = false;    // its standard output too, in the order in which both were written
  bool echoes = false;          // what is captured is also shown on our standard error as it comes
  bool has_no_input = false;    // it finds the end of its standard input at once
};

struct ProcessResult {
  int status = -1;        // exit status; 128 + n after signal n; 127 when it cannot be started
  std::string output;     // what was captured
  std::string not_found;  // why it could not be started; "" when it was
  bool good() const { return status == 0; }
};

// Runs `arguments` and waits for the end.  The first one is looked for in PATH.
ProcessResult RunProcess(const std::vector<std::string>& arguments,
                         const ProcessOptions& options = {});

// Whether PATH leads to a program of this name.
bool HasProgram(const std::string& name);

}  // namespace openr_host
