#include "kit/build_variant.h"

#include <fmt/format.h>

#include <cstdlib>

#include "kit/sdk_paths.h"

namespace openr_host {

std::string VariantName(BuildVariant variant) {
  switch (variant) {
    case BuildVariant::kDebug:
      return "debug";
    case BuildVariant::kSanitize:
      return "sanitize";
    case BuildVariant::kCoverage:
      return "coverage";
    default:
      return "";
  }
}

BuildVariant VariantOf(const std::string& name) {
  for (const BuildVariant variant :
       {BuildVariant::kDebug, BuildVariant::kSanitize, BuildVariant::kCoverage}) {
    if (VariantName(variant) == name) return variant;
  }
  return BuildVariant::kPlain;
}

BuildVariant VariantOfBuild() {
  const char* const name = std::getenv(kVariantVariable);
  return VariantOf(name == nullptr ? "" : name);
}

// Leaves out two checks of UndefinedBehaviorSanitizer.  The check "return" would end the program
// when a function of a type such as int ends without a return statement, but `openr build` makes
// this function return 0 (image_source.cc).  The check "vptr" needs functions that the runtime
// does not have
// (runtime/core/checked_code.cc).  The flag -fno-wrapv undoes the flag -fwrapv of
// compile-flags.txt, because with -fwrapv the sanitizer finds no overflow of a signed number.
std::vector<std::string> VariantCompileFlags(BuildVariant variant) {
  switch (variant) {
    case BuildVariant::kDebug:
      return {"-Og", "-g", "-fno-omit-frame-pointer", "-fno-optimize-sibling-calls"};
    case BuildVariant::kSanitize:
      return {"-O1",
              "-g",
              "-fno-omit-frame-pointer",
              "-fno-optimize-sibling-calls",
              "-fno-wrapv",
              "-fsanitize=address,undefined",
              "-fno-sanitize=vptr,return",
              "-fsanitize-recover=undefined"};
    case BuildVariant::kCoverage:
      return {"-O0", "-g", "--coverage", "-fprofile-update=single"};
    default:
      return {};
  }
}

std::vector<std::string> VariantLinkFlags(BuildVariant variant) {
  if (variant == BuildVariant::kSanitize) return {"-fsanitize=address"};
  if (variant == BuildVariant::kCoverage) return {"--coverage"};
  return {};
}

std::string VariantProblem(BuildVariant variant) {
  const bool needs_gnu = variant == BuildVariant::kSanitize || variant == BuildVariant::kCoverage;
  if (!needs_gnu || !IsClang(HostCompiler(Language::kCxx))) return "";
  return fmt::format("--{} needs g++; unset ${} and ${}, which name clang", VariantName(variant),
                     kCxxVariable, kCcVariable);
}

}  // namespace openr_host
