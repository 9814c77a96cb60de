// The SDK tree: what Makefiles of old programs expect below $(OPENRSDK_ROOT), made for the host.
//
//   bin/mipsel-linux-*        links to openr-sdk, which is what they mean here
//   OPEN_R/bin                stubgen2, mkbin and the other tools, links as well
//   OPEN_R/include            the SDK's headers (R4000 and MCOOP below it lead to the same ones)
//   OPEN_R/lib                empty libraries under the names that are linked
//   compat                    headers of C++ before the standard
//   compile-flags.txt         how old sources are compiled
//   images                    images that stand in for ones a program did not bring
//   controller                the Controller object to link controllers with, and their headers
//
// It is assembled by cmake/SdkTree.cmake, and lies at share/openr-host/sdk beside the bin/ of the
// program, built or installed.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Throws std::runtime_error when the program runs from where no SDK tree is.
std::string SdkRoot();

enum class Language { kC, kCxx };

// The flags of `text`, which is compile-flags.txt, for one language and compiler.
std::vector<std::string> ParseCompileFlags(const std::string& text, Language language,
                                           bool is_clang);

// Environment variables through which `openr build` and the tools it starts indirectly know of
// each other.  All may be missing: the tools then only do what they are named after.
inline constexpr char kLogVariable[] = "OPENR_KIT_LOG";        // file, see kit_log.h
inline constexpr char kStickVariable[] = "OPENR_KIT_STICK";    // the stick that rules write to
inline constexpr char kCopiesVariable[] = "OPENR_KIT_COPIES";  // "copy=original:copy=original"

// What may be set by a person: the compilers of the host, with arguments if need be.
inline constexpr char kCxxVariable[] = "OPENR_HOST_CXX";
inline constexpr char kCcVariable[] = "OPENR_HOST_CC";

// $OPENR_HOST_CXX or g++, $OPENR_HOST_CC or gcc, as words.
std::vector<std::string> HostCompiler(Language language);
bool IsClang(const std::vector<std::string>& compiler);

}  // namespace openr_host
