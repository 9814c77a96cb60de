#include "cli/prompt.h"

#include <histedit.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "cli/standard_streams.h"
#include "runtime/base/lazy_library.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

// Calls the macro F with the name of each function of libedit that this program uses.
#define OPENR_LIBEDIT_FUNCTIONS(F) \
  F(el_end)                        \
  F(el_get)                        \
  F(el_gets)                       \
  F(el_init) F(el_insertstr) F(el_line) F(el_set) F(history) F(history_end) F(history_init)

struct LibeditFunctions {
#define OPENR_LIBEDIT_POINTER(name) decltype(&::name) name;
  OPENR_LIBEDIT_FUNCTIONS(OPENR_LIBEDIT_POINTER)
#undef OPENR_LIBEDIT_POINTER
};

std::optional<LibeditFunctions> LoadLibedit() {
  try {
    const LazyLibrary library("libedit.so.2", "libedit, by which lines are edited,", "libedit2");
    LibeditFunctions functions;
#define OPENR_LIBEDIT_FIND(name) library.Find(&functions.name, #name);
    OPENR_LIBEDIT_FUNCTIONS(OPENR_LIBEDIT_FIND)
#undef OPENR_LIBEDIT_FIND
    return functions;
  } catch (const std::runtime_error&) {
    return {};
  }
}

// Returns the functions of libedit; null if libedit is missing, which is no error, because lines
// can be typed without it.
const LibeditFunctions* Libedit() {
  static const std::optional<LibeditFunctions> functions = LoadLibedit();
  return functions ? &*functions : nullptr;
}

// Returns whether lines can be edited: a person types them at a terminal that can move its cursor.
bool CanEdit() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1 && terminal != nullptr &&
         *terminal != '\0' && std::strcmp(terminal, "dumb") != 0;
}

// Edits one line.  The EditLine of libedit exists only while this object does.  So between two
// lines the terminal is as the program found it, and a process made by fork() then has no state of
// libedit through which it could change the terminal for other processes.
class LineEdit {
 public:
  LineEdit(const LibeditFunctions& libedit, const Prompt& prompt, const PromptHistory& history,
           const std::string& prompt_text)
      : libedit_(libedit),
        prompt_(prompt),
        prompt_text_(prompt_text),
        edit_(libedit.el_init("openr", stdin, stdout, stderr)),
        history_(libedit.history_init()) {
    if (edit_ == nullptr || history_ == nullptr) return;
    HistEvent event;
    libedit_.history(history_, &event, H_SETSIZE, 1000);
    for (const std::string& line : history.Lines())
      libedit_.history(history_, &event, H_ENTER, line.c_str());
    libedit_.el_set(edit_, EL_CLIENTDATA, this);
    libedit_.el_set(edit_, EL_PROMPT, &GivePrompt);
    libedit_.el_set(edit_, EL_HIST, libedit_.history, history_);
    libedit_.el_set(edit_, EL_EDITOR, "emacs");
    // Makes libedit restore the terminal when a signal ends the process.
    libedit_.el_set(edit_, EL_SIGNAL, 1);
    libedit_.el_set(edit_, EL_ADDFN, "openr-complete", "Completes a word", &CompleteWord);
    libedit_.el_set(edit_, EL_ADDFN, "openr-drop", "Drops the line", &DropLine);
    libedit_.el_set(edit_, EL_BIND, "^I", "openr-complete", nullptr);
    libedit_.el_set(edit_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    // Makes Ctrl-C a key and no signal, because a signal would reach all processes that openr
    // replay --step has made with fork(), also those that wait.  The flag -isig makes Ctrl-Z a key,
    // too, so Suspend() is bound to this key.
    libedit_.el_set(edit_, EL_SETTY, "-d", "-isig", nullptr);
    libedit_.el_set(edit_, EL_BIND, "^C", "openr-drop", nullptr);
    libedit_.el_set(edit_, EL_ADDFN, "openr-suspend", "Suspends the program", &Suspend);
    libedit_.el_set(edit_, EL_BIND, "^Z", "openr-suspend", nullptr);
  }
  ~LineEdit() {
    if (history_ != nullptr) libedit_.history_end(history_);
    if (edit_ != nullptr) libedit_.el_end(edit_);
  }
  LineEdit(const LineEdit&) = delete;
  LineEdit& operator=(const LineEdit&) = delete;

  bool is_good() const { return edit_ != nullptr && history_ != nullptr; }

  // Reads a line, which the user can edit while typing.  Returns false at the end of the input.
  bool Read(std::string* line) {
    for (;;) {
      is_dropped_ = false;
      int count = 0;
      // Prepares the terminal before el_gets() shows the prompt.  Otherwise keys that are pressed
      // before el_gets() prepares the terminal would be echoed, and Ctrl-C would be a signal.
      libedit_.el_set(edit_, EL_PREP_TERM, 1);
      const char* const text = libedit_.el_gets(edit_, &count);
      if (is_dropped_) continue;
      if (text == nullptr || count <= 0) {
        std::fputc('\n', stdout);
        return false;
      }
      line->assign(text, static_cast<size_t>(count));
      line->erase(line->find_last_not_of(" \n") + 1);  // also removes a blank that Tab has added
      return true;
    }
  }

 private:
  static LineEdit* Of(EditLine* edit) {
    void* self = nullptr;
    Libedit()->el_get(edit, EL_CLIENTDATA, &self);
    return static_cast<LineEdit*>(self);
  }

  static char* GivePrompt(EditLine* edit) { return Of(edit)->prompt_text_.data(); }

  static unsigned char DropLine(EditLine* edit, int) {
    Of(edit)->is_dropped_ = true;
    std::fputs("^C\n", stdout);
    return CC_NEWLINE;
  }

  static unsigned char Suspend(EditLine*, int) {
    // Sends SIGTSTP to this process, as Ctrl-Z does.  libedit handles this signal: it restores the
    // terminal, and prepares the terminal again when the program goes on.
    raise(SIGTSTP);
    return CC_REDISPLAY;
  }

  static unsigned char CompleteWord(EditLine* edit, int) {
    const LineInfo& info = *Libedit()->el_line(edit);
    const std::string begin(info.buffer, info.cursor);
    std::vector<std::string> choices;
    std::string more;
    try {
      more = Of(edit)->prompt_.Continuation(begin, &choices);
    } catch (const std::exception&) {
      // Catches an exception of the function that finds the words for Tab, because an exception
      // must not pass through the functions of libedit, which are in C.  The user learns the reason
      // of the exception, such as that the run has ended, when the typed line is carried out.
      return CC_REFRESH_BEEP;
    }
    if (!more.empty())
      return Libedit()->el_insertstr(edit, more.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    if (choices.empty()) return CC_REFRESH_BEEP;
    PrintInColumns(choices);
    return CC_REDISPLAY;
  }

  static void PrintInColumns(const std::vector<std::string>& words) {
    constexpr size_t kColumns = 80;
    size_t width = 0;
    for (const std::string& word : words) width = std::max(width, word.size() + 2);
    const size_t in_line = std::max<size_t>(1, kColumns / width);
    for (size_t i = 0; i < words.size(); ++i) {
      std::fputs(i % in_line == 0 ? "\n" : "", stdout);
      const bool is_last = i % in_line == in_line - 1 || i + 1 == words.size();
      std::printf("%-*s", is_last ? 0 : static_cast<int>(width), TerminalLine(words[i]).c_str());
    }
    std::fputc('\n', stdout);
  }

  const LibeditFunctions& libedit_;
  const Prompt& prompt_;
  std::string prompt_text_;
  EditLine* const edit_;
  History* const history_;
  bool is_dropped_ = false;
};

}  // namespace

void PromptHistory::Add(std::string_view line) {
  if (line.empty() || line.find('\n') != std::string_view::npos || line.size() >= kBytesMax) return;
  const std::vector<std::string> lines = Lines();
  if (!lines.empty() && lines.back() == line) return;
  std::string text(text_, size_);
  text.append(line).push_back('\n');
  while (text.size() > kBytesMax) text.erase(0, text.find('\n') + 1);
  std::memcpy(text_, text.data(), text.size());
  size_ = static_cast<uint32_t>(text.size());
}

std::vector<std::string> PromptHistory::Lines() const {
  std::vector<std::string> lines;
  std::istringstream stream(std::string(text_, size_));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool Prompt::Read(const std::string& prompt, std::string* line) {
  FlushAnswer();
  if (CanEdit() && Libedit() != nullptr) {
    LineEdit edit(*Libedit(), *this, *history_, prompt);
    if (edit.is_good()) {
      if (!edit.Read(line)) return false;
      history_->Add(*line);
      return true;
    }
  }
  PrintAnswer(prompt);
  FlushAnswer();
  return ReadPlain(line);
}

// Reads a line byte by byte, because bytes in a buffer would be lost for another process that goes
// on with the input.
bool Prompt::ReadPlain(std::string* line) {
  line->clear();
  for (char c = 0; read(STDIN_FILENO, &c, 1) == 1;) {
    if (c == '\n') return true;
    line->push_back(c);
  }
  return !line->empty();
}

std::string Prompt::Continuation(const std::string& begin,
                                 std::vector<std::string>* choices) const {
  choices->clear();
  std::vector<std::string> words;
  std::istringstream stream(begin);
  for (std::string word; stream >> word;) words.push_back(word);
  std::string start;  // the typed part of the word that Tab completes
  if (!begin.empty() && begin.back() != ' ' && !words.empty()) {
    start = words.back();
    words.pop_back();
  }
  std::vector<std::string> fitting;
  for (const std::string& word : complete_(words, start)) {
    if (word.starts_with(start)) fitting.push_back(word);
  }
  std::sort(fitting.begin(), fitting.end());
  fitting.erase(std::unique(fitting.begin(), fitting.end()), fitting.end());
  if (fitting.empty()) return "";
  if (fitting.size() == 1) return fitting[0].substr(start.size()) + " ";
  const std::string& first = fitting.front();
  const std::string& last = fitting.back();
  size_t common = 0;
  while (common < first.size() && common < last.size() && first[common] == last[common]) ++common;
  if (common == start.size()) *choices = fitting;
  return first.substr(start.size(), common - start.size());
}

}  // namespace openr_host
