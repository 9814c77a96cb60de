// Calls of functions of the C and C++ libraries that are called in an unusual way.
#ifndef Imports_h_DEFINED
#define Imports_h_DEFINED

#include <string>

// The answer to `command`; empty when it is not about imported functions.
std::string AnswerImports(const std::string& command);

#endif  // Imports_h_DEFINED
