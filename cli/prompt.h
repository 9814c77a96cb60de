// Prompt: reads the lines that a person types, with editing, history and completion by Tab.
//
// On a terminal, the library libedit does the editing.  It is loaded when the first line is read
// and not at the start of the program.  If libedit is missing, or if input or output is no
// terminal, lines are read without editing.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openr_host {

// The last lines that were typed at a prompt, in memory of a fixed size without pointers.  So the
// history may lie in memory that several processes share, and a prompt that goes on in another
// process keeps its history.
class PromptHistory {
 public:
  // Adds a line to the history, unless the line is empty or equal to the last line.  Removes the
  // oldest lines if there is no room.
  void Add(std::string_view line);
  // Returns the typed lines, the oldest first.
  std::vector<std::string> Lines() const;

 private:
  static constexpr uint32_t kBytesMax = 16 << 10;

  uint32_t size_ = 0;
  char text_[kBytesMax] = {};  // typed lines, each with '\n' at its end; `size_` bytes are used
};

class Prompt {
 public:
  // A function that returns the words to which Tab may complete a word of the line.  `words` are
  // the words before this word, and `start` is the part of this word that the user has typed.  The
  // function may also return words that do not begin with `start`; they are ignored.  If the
  // function throws, no word is completed.
  using Complete = std::function<std::vector<std::string>(const std::vector<std::string>& words,
                                                          const std::string& start)>;

  // `history` must outlive the prompt.  The prompt adds each line that it reads with libedit to
  // `history`.
  Prompt(PromptHistory* history, Complete complete)
      : history_(history), complete_(std::move(complete)) {}

  // Prints `prompt` on standard output and reads a line from standard input, without its end.
  // Returns false at the end of the input.  Throws as PrintAnswer() does (standard_streams.h).  If
  // libedit is used, Ctrl-C drops the typed text and begins a new line; without libedit, Ctrl-C
  // ends the process.  Nothing that follows the line is read, so another process can go on with the
  // input.
  bool Read(const std::string& prompt, std::string* line);

  // Returns the text that Tab inserts at the end of `begin`, the line up to the cursor; "" if no
  // word fits.  If several words fit and do not go on with the same letter, returns "" and sets
  // `choices` to these words.
  std::string Continuation(const std::string& begin, std::vector<std::string>* choices) const;

 private:
  bool ReadPlain(std::string* line);

  PromptHistory* const history_;
  const Complete complete_;
};

}  // namespace openr_host
