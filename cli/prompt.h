// Prompt: reads the lines that a person types, with editing, history and completion by Tab.
//
// On a terminal libedit does this.  It is loaded when the first line is read and not with the
// program.  If it is missing, or if input or output is no terminal, the lines are read as they
// come.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openr_host {

// The last lines that were typed at a prompt, in memory of a fixed size without pointers.  So it
// may lie in memory that several processes share, and a session that goes on in another process
// keeps its history.
class PromptHistory {
 public:
  // Adds a line, unless it is empty or equal to the last one.  Removes the oldest lines if there is
  // no room.
  void Add(std::string_view line);
  // Returns the lines, the oldest first.
  std::vector<std::string> Lines() const;

 private:
  static constexpr uint32_t kBytesMax = 16 << 10;

  uint32_t size_ = 0;
  char text_[kBytesMax] = {};  // of the `size_` bytes in use, each line ends with '\n'
};

class Prompt {
 public:
  // Returns all words that may stand at the end of a line that begins with `words`, the whole words
  // in front of it.  If the function throws, nothing is completed.
  using Complete = std::function<std::vector<std::string>(const std::vector<std::string>& words)>;

  // `history` must outlive the prompt.  The prompt adds each line to it.
  Prompt(PromptHistory* history, Complete complete)
      : history_(history), complete_(std::move(complete)) {}

  // Prints `prompt` to stdout and reads a line from standard input, without its end.
  // Returns false at the end of the input.  Ctrl-C drops what was typed, where libedit is used, and
  // a new line begins; elsewhere it ends the process.  Nothing that follows the line is read, so
  // another process can go on with the input.
  bool Read(const std::string& prompt, std::string* line);

  // Returns what is to be inserted at the end of `begin`, the line up to the cursor.  If that is
  // nothing, because there is no single continuation, sets `choices` to the words that fit.
  std::string Continuation(const std::string& begin, std::vector<std::string>* choices) const;

 private:
  bool ReadPlain(std::string* line);

  PromptHistory* const history_;
  const Complete complete_;
};

}  // namespace openr_host
