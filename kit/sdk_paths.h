// The SDK tree: the files that Makefiles of old programs expect below $(OPENRSDK_ROOT), for the
// host.
//
//   bin/mipsel-linux-*   links to openr-sdk, which acts as the tool of that name
//   OPEN_R/bin           stubgen2, mkbin and the other tools; also links to openr-sdk
//   OPEN_R/include       headers of the SDK; R4000 and MCOOP in it are links to this folder
//   OPEN_R/lib           empty libraries under the names that programs link
//   compat               headers of C++ before its first standard, such as iostream.h
//   compile-flags.txt    flags for compiling old sources
//   images               images for programs that do not bring their own, such as POWERMON.BIN
//   controller           the Controller object to link controllers with, and its headers
//
// cmake/MakeSdkTree.cmake puts the tree together in share/openr-host/sdk.  This folder is beside
// the bin/ of the program, both in the build tree and after installing.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the root of the SDK tree.  Throws std::runtime_error if there is no SDK tree beside the
// program.
std::string SdkRoot();

enum class Language { kC, kCxx };

// Returns the flags in `text`, the content of compile-flags.txt, for one language and compiler.
std::vector<std::string> ParseCompileFlags(const std::string& text, Language language,
                                           bool is_clang);

// The next constants are environment variables that `openr build` sets for the tools that make
// starts.  Without these variables, the tools do what the SDK's tools of the same names do, and do
// nothing for `openr build`.
inline constexpr char kLogVariable[] = "OPENR_KIT_LOG";  // path of the log, see kit_log.h
// Environment variable: the path of the stick to which rules of Makefiles write.
inline constexpr char kStickVariable[] = "OPENR_KIT_STICK";
// Environment variable: pairs of folders, "copy=original:copy=original", of the private copies in
// which make runs; see source_copies.h.
inline constexpr char kCopiesVariable[] = "OPENR_KIT_COPIES";
// Environment variable: the name of the variant to build, such as "debug"; see build_variant.h.
inline constexpr char kVariantVariable[] = "OPENR_KIT_VARIANT";

// Environment variable by which the user may name the C++ compiler of the host, with arguments if
// needed.
inline constexpr char kCxxVariable[] = "OPENR_HOST_CXX";

// Environment variable by which the user may name the C compiler of the host.
inline constexpr char kCcVariable[] = "OPENR_HOST_CC";

// Returns the command of the host's compiler for a language, as words.  For C++ the command is the
// value of $OPENR_HOST_CXX, or "g++"; for C it is the value of $OPENR_HOST_CC, or "gcc".
std::vector<std::string> HostCompiler(Language language);
bool IsClang(const std::vector<std::string>& compiler);

}  // namespace openr_host
