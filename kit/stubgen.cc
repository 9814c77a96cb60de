#include "kit/stubgen.h"

#include <fmt/format.h>
#include <getopt.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

#include "cli/output_file.h"
#include "runtime/base/read_file.h"
#include "runtime/base/terminal_text.h"
#include "runtime/config/stub_config.h"
#include "runtime/config/stub_generator.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kHelp[] =
    R"(Generates def.h, entry.h and the stub of an OPEN-R object from its stub.cfg.

{name} [FILE] [-o DIR]

  FILE              stub.cfg to read; without it, and for '-', standard input
  -o, --output DIR  folder to write to; the current one when it is not given
)";

constexpr int kGood = 0;
constexpr int kInputWrong = 1;
constexpr int kCommandLineWrong = 2;

std::optional<std::string> ReadStream(std::istream& in) {
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) return std::nullopt;
  return text;
}

// Returns the text of `file`, or of the stream `in` if `file` is "".  Returns nullopt after
// printing an error.
std::optional<std::string> ReadInput(const std::string& file, std::istream& in, std::ostream& err) {
  if (file.empty()) {
    std::optional<std::string> text = ReadStream(in);
    if (!text) err << "standard input: cannot be read\n";
    return text;
  }
  std::error_code status;
  if (fs::is_directory(file, status)) {
    err << TerminalText(fmt::format("{0}: is a folder; did you mean '{0}/stub.cfg'?\n", file));
    return std::nullopt;
  }
  std::optional<std::string> text = ReadFile(file);
  if (!text)
    err << TerminalText(fmt::format("{}: cannot be read: {}\n", file, std::strerror(errno)));
  return text;
}

// Writes all files or none: gives the files their final names only when all contents are on the
// disk.  Returns "" or the error message.
std::string WriteTogether(const std::vector<GeneratedFile>& files, const fs::path& folder) {
  std::vector<PendingFile> pending;
  for (const GeneratedFile& file : files) {
    const fs::path path = folder / file.name;
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      return fmt::format("{}: is a folder; remove it, a file of this name is to be written",
                         path.string());
    }
    pending.emplace_back(path);
    const std::string problem = pending.back().Write(file.text);
    if (!problem.empty()) return problem;
  }
  for (PendingFile& file : pending) {
    const std::string problem = file.Commit();
    if (!problem.empty()) return problem;
  }
  return "";
}

bool WriteFiles(const std::vector<GeneratedFile>& files, const fs::path& folder,
                std::ostream& err) {
  std::error_code status;
  fs::create_directories(folder, status);
  if (status) {
    err << TerminalText(fmt::format("{}: cannot be made: {}\n", folder.string(), status.message()));
    return false;
  }
  const std::string fault = WriteTogether(files, folder);
  if (!fault.empty()) err << TerminalText(fault) << '\n';
  return fault.empty();
}

std::string Counted(size_t count, const char* singular, const char* plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

std::string Summary(const StubConfig& config, const std::vector<GeneratedFile>& files,
                    const fs::path& folder) {
  std::string text = fmt::format("{}: {}, {}, {}; selectors 0 to {}\n", config.object_name,
                                 Counted(config.subjects.size(), "subject", "subjects"),
                                 Counted(config.observers.size(), "observer", "observers"),
                                 Counted(config.extras.size(), "extra entry", "extra entries"),
                                 config.NumOfSelectors() - 1);
  for (const GeneratedFile& file : files) {
    text += fmt::format("wrote {}\n", (folder / file.name).lexically_normal().string());
  }
  return text;
}

}  // namespace

int RunStubgen(const StubgenOptions& options, std::istream& in, std::ostream& out,
               std::ostream& err) {
  const std::string file = options.file == "-" ? "" : options.file;
  const std::optional<std::string> text = ReadInput(file, in, err);
  if (!text) return kInputWrong;
  const StubConfigResult parsed = ParseStubConfig(file.empty() ? "<stdin>" : file, *text);
  err << Render(parsed.diagnostics);
  if (HasErrors(parsed.diagnostics)) {
    err << "nothing written\n";
    return kInputWrong;
  }
  const std::string source = file.empty() ? "stub.cfg" : fs::path(file).filename().string();
  const std::vector<GeneratedFile> files = GenerateStub(parsed.config, source);
  if (!WriteFiles(files, options.folder, err)) return kInputWrong;
  out << TerminalText(Summary(parsed.config, files, options.folder));
  return kGood;
}

int StubgenMain(int argc, char** argv) {
  constexpr option kFlags[] = {
      {"output", required_argument, nullptr, 'o'}, {"help", no_argument, nullptr, 'h'}, {}};
  const auto refuse = [argv](const std::string& why) {
    std::cerr << TerminalText(fmt::format("{0}: {1}; '{0} --help' tells more\n", argv[0], why));
    return kCommandLineWrong;
  };
  StubgenOptions options;
  optind = 0;  // makes getopt forget an earlier command line
  opterr = 0;
  for (;;) {
    const int flag = getopt_long(argc, argv, "o:h", kFlags, nullptr);
    if (flag == -1) break;
    if (flag == 'o') {
      options.folder = optarg;
    } else if (flag == 'h') {
      std::fputs(fmt::format(kHelp, fmt::arg("name", argv[0])).c_str(), stdout);
      return kGood;
    } else {
      const bool is_bare = optopt == 'o';
      return refuse(is_bare ? "-o needs a folder"
                            : fmt::format("there is no flag {}", argv[optind - 1]));
    }
  }
  if (argc - optind > 1) return refuse("one stub.cfg is read at a time");
  if (optind < argc) options.file = argv[optind];
  return RunStubgen(options, std::cin, std::cout, std::cerr);
}

}  // namespace openr_host
