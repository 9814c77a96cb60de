// The calls of openr in README.md, docs/ and the pages of examples/ are understood by the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/openr/command_check.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

struct DocumentedCall {
  int line = 0;  // from 1
  CallWords words;
  // kSome for a call within a sentence, which may name only a part of a command: `openr replay`.
  Arguments arguments = Arguments::kAll;
};

// Finds the calls of openr on a page: in indented blocks, in fenced blocks of a shell, and in texts
// between backticks that begin with openr.
class PageCalls {
 public:
  explicit PageCalls(const std::string& page) {
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) Read(line);
  }
  const std::vector<DocumentedCall>& calls() const { return calls_; }

 private:
  void Read(const std::string& line) {
    ++number_;
    static const std::regex kFence("^ *(?:```|~~~)(.*)$");
    std::smatch fence;
    if (std::regex_match(line, fence, kFence)) {
      fence_ = fence_ ? std::nullopt : std::optional<std::string>(fence[1]);
      return;
    }
    if (IsTyped(line)) ReadTyped(line);
    if (!fence_) ReadSentence(line);
  }
  // Returns whether a line is one of a shell.  Leaves out blocks whose commands have to fail; those
  // are run by tests/docs/run_docs.py.
  bool IsTyped(const std::string& line) const {
    if (!fence_) return line.starts_with("    ");
    return (fence_->empty() || fence_->starts_with("sh") || fence_->starts_with("bash")) &&
           fence_->find("status=") == std::string::npos;
  }
  void ReadTyped(const std::string& line) {
    typed_ += line;
    if (typed_.ends_with('\\')) {
      typed_.back() = ' ';
      return;
    }
    Add(typed_, Arguments::kAll);
    typed_.clear();
  }
  void ReadSentence(const std::string& line) {
    static const std::regex kText("`((?:\\./dev )?openr [^`]*)`");
    for (std::sregex_iterator it(line.begin(), line.end(), kText), end; it != end; ++it)
      Add((*it)[1], Arguments::kSome);
  }
  void Add(const std::string& line, Arguments arguments) {
    for (CallWords& words : CallsIn(line)) {
      std::erase(words, "ARGS");  // stands for any arguments
      if (!words.empty()) calls_.push_back({number_, std::move(words), arguments});
    }
  }

  std::vector<DocumentedCall> calls_;
  int number_ = 0;                    // number of the newest line
  std::optional<std::string> fence_;  // text behind the fence of the open block
  std::string typed_;                 // lines that ended with a backslash
};

// Returns whether a call describes other calls: "[--json]" may be left out, "..." stands for more.
bool IsSynopsis(const CallWords& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.find('[') != std::string::npos || word.find("...") != std::string::npos;
  });
}

// Returns whether a word stands for values that the reader chooses, such as FILE, HOST:PORT or
// $robot.
bool IsPlaceholder(const std::string& word) {
  static const std::regex kCapitals("[A-Z][A-Z0-9:]*");
  return word.find('$') != std::string::npos || std::regex_match(word, kCapitals);
}

// Writes what a call names into the working folder: the reader of the page has these files.
void ProvideFiles(const CallWords& words) {
  std::string before;
  for (const std::string& word : words) {
    const std::filesystem::path path(word);
    const bool is_folder = before == "--stick" || before == "--images";
    if (path.is_relative() && is_folder) {
      std::filesystem::create_directories(path);
    } else if (path.is_relative() && path.has_extension()) {
      if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
      std::ofstream(path) << (path.extension() == ".xml"
                                  ? "<CycloneDDS><Domain id=\"any\"/></CycloneDDS>"
                                  : "");
    }
    before = word;
  }
}

bool Is(const CLI::ParseError& error, CLI::ExitCodes code) {
  return error.get_exit_code() == static_cast<int>(code);
}

// Returns the error of a call.  Adds words that a sentence leaves out, because CLI11 reports a
// missing word before an unknown flag.
std::optional<CLI::ParseError> ErrorOfCompleted(DocumentedCall* call) {
  constexpr int kWordsMax = 4;  // words that are added at most
  std::optional<CLI::ParseError> error = ParseErrorOf(call->words, call->arguments);
  for (int i = 0; i < kWordsMax && call->arguments == Arguments::kSome; ++i) {
    if (!error || !Is(*error, CLI::ExitCodes::RequiredError)) break;
    call->words.push_back("WORD");
    error = ParseErrorOf(call->words, call->arguments);
  }
  return error;
}

// Returns why the program does not understand a call; "" if it does.
std::string CallProblem(DocumentedCall call) {
  const std::optional<CLI::ParseError> error = ErrorOfCompleted(&call);
  if (!error) return "";
  const bool is_of_value =
      Is(*error, CLI::ExitCodes::ValidationError) || Is(*error, CLI::ExitCodes::ConversionError);
  if (is_of_value && std::any_of(call.words.begin(), call.words.end(), &IsPlaceholder)) return "";
  // `openr run --stick` names a flag without its value.
  if (Is(*error, CLI::ExitCodes::ArgumentMismatch) && call.arguments == Arguments::kSome) return "";
  return error->what();
}

// Returns the pages whose calls are checked.  Design notes are left out: they say what was planned.
std::vector<std::filesystem::path> Pages() {
  const std::filesystem::path docs = OPENR_DOCS, root = docs.parent_path();
  std::vector<std::filesystem::path> pages = {root / "README.md"};
  for (const std::filesystem::path& folder : {docs, root / "examples"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const bool is_note = entry.path().parent_path() == docs / "decisions";
      if (entry.path().extension() == ".md" && !is_note) pages.push_back(entry.path());
    }
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

// The errors of a page, "LINE: openr WORDS: ERROR" each.  Leaves out calls that are in `seen`, and
// adds those of this page.
std::vector<std::string> ErrorsOn(const std::string& page,
                                  std::set<std::pair<CallWords, Arguments>>* seen) {
  std::vector<std::string> errors;
  const PageCalls page_calls(page);
  for (const DocumentedCall& call : page_calls.calls()) {
    if (IsSynopsis(call.words) || !seen->insert({call.words, call.arguments}).second) continue;
    const ScratchFolder folder;
    std::filesystem::current_path(folder.path());
    ProvideFiles(call.words);
    const std::string error = CallProblem(call);
    if (error.empty()) continue;
    std::string text = std::to_string(call.line) + ": openr";
    for (const std::string& word : call.words) text += " " + word;
    errors.push_back(text + ": " + error);
  }
  return errors;
}

std::vector<std::string> ErrorsOn(const std::string& page) {
  std::set<std::pair<CallWords, Arguments>> seen;
  return ErrorsOn(page, &seen);
}

// Restores the working folder, which ErrorsOn() changes.
class DocumentedCommandsTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::current_path(before_); }
  const std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(DocumentedCommandsTest, TheOutputOfACommandIsAWord) {
  EXPECT_EQ(ErrorsOn("    openr rc $(grep -o ':[0-9]*' run.txt) power\n").size(), 0u);
}

TEST_F(DocumentedCommandsTest, EveryCallOnAPageIsUnderstood) {
  size_t call_count = 0;
  std::set<std::pair<CallWords, Arguments>> seen;
  for (const std::filesystem::path& path : Pages()) {
    std::ifstream stream(path);
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    call_count += PageCalls(page).calls().size();
    for (const std::string& error : ErrorsOn(page, &seen))
      ADD_FAILURE() << path.string() << ":" << error;
  }
  EXPECT_GT(call_count, 600u);  // the pages were found and read
}

TEST_F(DocumentedCommandsTest, AWrongCallIsFoundWhereverItStands) {
  EXPECT_EQ(ErrorsOn("    openr run --fro 20s\n").size(), 1u);
  EXPECT_EQ(ErrorsOn("    ./dev openr run \\\n        --for 5m   # five minutes\n").size(), 1u);
  EXPECT_EQ(ErrorsOn("```sh\nopenr run --robot ers9 >run.txt 2>&1 &\n```\n").size(), 1u);
  EXPECT_EQ(ErrorsOn("```sh\nopenr trace a.rec | tail; openr replay\n```\n").size(), 1u);
  EXPECT_EQ(
      ErrorsOn("See `openr rnu`, `openr replay --stpe` or `openr rc sensors --watch`.\n").size(),
      3u);
}

TEST_F(DocumentedCommandsTest, ACallIsWhatAReaderTypes) {
  EXPECT_EQ(ErrorsOn("```output\nopenr build: note: no source\n```\n").size(), 0u);
  EXPECT_EQ(
      ErrorsOn("See `openr replay`, `openr run --stick` and `openr run --robots N`.\n").size(), 0u);
  EXPECT_EQ(ErrorsOn("    X=1 openr explore --property 'forward_m_s < 5' # --no-flag\n").size(),
            0u);
  EXPECT_EQ(ErrorsOn("    openr stick check DIR [--robot M]\n").size(), 0u);
}

}  // namespace
}  // namespace openr_host
