// The tools mipsel-linux-g++ and mipsel-linux-gcc, which compile for the host.  If a source does
// not compile, the tools compile it again: first with more declarations, then with repairs of code
// that only the old compiler accepted.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/build_variant.h"
#include "kit/compile_command.h"
#include "kit/kit_log.h"
#include "kit/sdk_tools.h"
#include "kit/source_copies.h"
#include "kit/source_repair.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

// Largest number of rounds in which the compile tool repairs one source and compiles it again.
constexpr int kRepairRoundsMax = 40;

size_t CountErrors(const std::string& output) {
  size_t count = 0;
  for (size_t at = output.find("error: "); at != std::string::npos;
       at = output.find("error: ", at + 1))
    ++count;
  return count;
}

// Returns `output`, the messages of g++, without the notes in which g++ says that it does not know
// a flag of the form -Wno-x.
std::string WithoutFlagNotes(const std::string& output) {
  std::istringstream lines(output);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("may have been intended to silence earlier diagnostics") == std::string::npos &&
        line != "At global scope:" && line != "At top level:")
      kept += line + "\n";
  }
  return kept;
}

class CompileRun {
 public:
  CompileRun(const Arguments& arguments, bool is_cxx);

  int Run();

 private:
  Arguments WordsWith(const Arguments& extra, const Arguments& own) const;
  void Log(bool is_good) const;
  ProcessResult Try(const Arguments& extra);
  ProcessResult TryKnownFlags(const Arguments& extra);
  void UsePreludeIfItHelps(ProcessResult* result);
  void RepairIfItHelps(ProcessResult* result);

  const Arguments given_;
  CompileCommand command_;
  Arguments compiler_;  // the host's compiler and the flags of compile-flags.txt
  Arguments extra_;     // flags for this source in addition to the flags of the user's command
  Arguments variant_;   // flags of the variant, such as "debug", that is built
};

CompileRun::CompileRun(const Arguments& arguments, bool is_cxx)
    : given_(arguments), command_(TranslateCompile(arguments, is_cxx)) {
  const std::string root = SdkRoot();
  compiler_ = HostCompiler(is_cxx ? Language::kCxx : Language::kC);
  const Arguments flags = ParseCompileFlags(ReadFile(root + "/compile-flags.txt").value_or(""),
                                            command_.language, IsClang(compiler_));
  compiler_.insert(compiler_.end(), flags.begin(), flags.end());
  if (command_.compiles) {
    variant_ = VariantCompileFlags(VariantOfBuild());
    compiler_.push_back("-g");
    for (const SourceCopy& copy : SourceCopies()) {
      // Lets debug information name the user's files, because private copies of them are compiled.
      compiler_.push_back("-ffile-prefix-map=" + copy.copy + "=" + copy.original);
    }
  }
  command_.arguments.insert(command_.arguments.end(),
                            {"-isystem", root + "/OPEN_R/include", "-isystem", root + "/compat"});
}

// Returns the command line of the host's compiler: the compiler with the kit's own flags, the flags
// `extra`, the arguments `own`, and the flags of the variant.  `own` are all arguments of the
// user's command, or a part of them.
Arguments CompileRun::WordsWith(const Arguments& extra, const Arguments& own) const {
  Arguments all = compiler_;
  all.insert(all.end(), extra.begin(), extra.end());
  all.insert(all.end(), own.begin(), own.end());
  // Puts the flags of the variant last, because the last one of several flags -O counts.
  all.insert(all.end(), variant_.begin(), variant_.end());
  return all;
}

ProcessResult CompileRun::Try(const Arguments& extra) {
  // Sets the language of the compiler's messages to English, because these messages are parsed.
  return RunProcess(WordsWith(extra, command_.arguments),
                    {.environment = {{"LC_ALL", "C"}}, .captures_error = true});
}

// Compiles the sources.  If the host's compiler does not know some of the flags, compiles again
// without these flags, which are flags of an old compiler.  Returns the result of the last
// compilation.
ProcessResult CompileRun::TryKnownFlags(const Arguments& extra) {
  ProcessResult result = Try(extra);
  while (!result.good()) {
    size_t left_out = 0;
    for (const std::string& flag : UnknownFlags(result.output)) {
      left_out += std::erase(command_.arguments, flag);
    }
    if (left_out == 0) break;
    result = Try(extra);
  }
  return result;
}

void CompileRun::UsePreludeIfItHelps(ProcessResult* result) {
  if (command_.language != Language::kCxx) return;
  const Arguments prelude = {"-include", SdkRoot() + "/compat/openr_prelude.h"};
  const ProcessResult again = Try(prelude);
  if (!again.good() && CountErrors(again.output) >= CountErrors(result->output)) return;
  extra_ = prelude;
  *result = again;
}

// Repairs the private copies of the source and of its headers in rounds, until the source compiles
// or no rule of repair_rules.h fits its errors.  If the source does not compile in the end, undoes
// all repairs.
void CompileRun::RepairIfItHelps(ProcessResult* result) {
  RepairSession session;
  if (!session.may_repair()) return;
  // Compiles the file once more without the flags of earlier repairs, because another compiler
  // process may have repaired a header while this process waited for the lock.
  extra_.clear();
  ProcessResult now = Try({});
  if (!now.good()) UsePreludeIfItHelps(&now);
  for (int round = 0; !now.good() && round < kRepairRoundsMax; ++round) {
    Arguments as_json = extra_;
    // Asks for all errors, because each round of repairs then repairs as many errors as it can.
    as_json.insert(as_json.end(), {"-fdiagnostics-format=json", "-fmax-errors=0"});
    if (!session.Apply(Try(as_json).output, command_.sources)) break;
    now = Try(extra_);
    if (!now.good() && extra_.empty()) UsePreludeIfItHelps(&now);
  }
  *result = now;  // the errors that are left are shown to the user
  if (now.good()) {
    session.Keep();
  } else {
    session.Undo();
  }
}

// Records for `openr build` the compiled sources, the flags, and whether the compiler succeeded.
void CompileRun::Log(bool is_good) const {
  const std::string here = std::filesystem::current_path();
  Arguments flags;
  for (size_t i = 0; i < command_.arguments.size(); ++i) {
    const std::string& word = command_.arguments[i];
    if (word == "-o") {
      ++i;  // skips the file name after -o
    } else if (word != "-c" && std::find(command_.sources.begin(), command_.sources.end(), word) ==
                                   command_.sources.end()) {
      flags.push_back(word);
    }
  }
  for (const std::string& source : command_.sources) {
    LogCompile({source, here, CarriedFlags(given_, here)});
    LogCommand({source, here, WordsWith(extra_, flags)});
    const std::string output = command_.output.empty()
                                   ? std::filesystem::path(source).stem().string() + ".o"
                                   : command_.output;
    if (is_good) {
      LogSuccess(output);
    } else {
      LogFailure({source, "does not compile", output});
    }
  }
}

int CompileRun::Run() {
  if (!command_.compiles) {
    const ProcessResult result = TryKnownFlags({});
    std::fputs(result.output.c_str(), stderr);
    return result.status;
  }
  ProcessResult result = TryKnownFlags({});
  if (!result.good() && result.start_error.empty()) {
    UsePreludeIfItHelps(&result);
    if (!result.good()) RepairIfItHelps(&result);
  }
  if (result.good() && TellsOfMissingReturn(result.output) && !IsClang(compiler_)) {
    // Adds a flag with which each function calls a helper (image_source.cc) just before it returns.
    // The helper makes the function return 0 if the function sets no return value.
    extra_.insert(extra_.end(), {"-finstrument-functions", kNoHelpersInLibrary});
    const ProcessResult again = Try(extra_);
    if (again.good()) result = again;
  }
  if (!result.good() || !command_.is_quiet)
    std::fputs(InTermsOfOriginals(WithoutFlagNotes(result.output), SourceCopies()).c_str(), stderr);
  if (!result.start_error.empty()) PrintPlain(stderr, "{}\n", result.start_error);
  Log(result.good());
  return result.status;
}

}  // namespace

int RunCompiler(const Arguments& arguments, bool is_cxx) {
  return CompileRun(arguments, is_cxx).Run();
}

}  // namespace openr_host
