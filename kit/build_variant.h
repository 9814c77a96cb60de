// Variants of a build of the user's objects: for a debugger, with sanitizers, with coverage
// counters.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

enum class BuildVariant { kPlain, kDebug, kSanitize, kCoverage };

// Returns "debug", "sanitize" or "coverage"; "" for kPlain, the build without special flags.
std::string VariantName(BuildVariant variant);
// Returns the variant whose name is `name` ("debug" for kDebug); kPlain if no variant has this
// name.
BuildVariant VariantOf(const std::string& name);

// Returns the variant that `openr build` has named in the environment variable kVariantVariable for
// the tools that compile and link.
BuildVariant VariantOfBuild();

// Returns the compiler flags of a variant.  They follow the flags of the user's Makefile, because
// the compiler obeys the last of two flags that contradict each other (-O2, -O0).
std::vector<std::string> VariantCompileFlags(BuildVariant variant);

// Returns the linker flags of a variant.
std::vector<std::string> VariantLinkFlags(BuildVariant variant);

// Returns the reason why the compiler that the user has chosen cannot build `variant`; "" if the
// compiler can.
std::string VariantProblem(BuildVariant variant);

}  // namespace openr_host
