#include "runtime/config/line_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "runtime/base/assert.h"
#include "runtime/base/characters.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
// Messages show only this many bytes of a line that is too long.
constexpr size_t kQuotedBytesMax = 60;

// The robot designs that OPENR::GetRobotDesign() can return.  Other designs are legal (a stick's
// DESIGN.CFG may name its own), so this list serves only to warn about misspelt names.
const std::vector<std::string> kKnownDesigns = {"ERS-210", "ERS-220", "ERS-7"};

std::string_view Trim(std::string_view text) {
  while (!text.empty() && IsBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && IsBlank(text.back())) text.remove_suffix(1);
  return text;
}

// Removes and returns the first line of `rest`, without LF or CR LF.
std::string_view TakeLine(std::string_view* rest) {
  const size_t end = rest->find('\n');
  std::string_view line = rest->substr(0, end);
  rest->remove_prefix(end == std::string_view::npos ? rest->size() : end + 1);
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

// Keeps track of the sections of a file, such as [ERS-210], so that the parser can skip the lines
// of sections for other robot designs.
class SectionFilter {
 public:
  SectionFilter(std::string_view design, std::vector<Diagnostic>* diagnostics)
      : design_(design), diagnostics_(diagnostics) {}

  // Returns whether the lines of the current section, such as [ERS-210], are for the robot design
  // that was given to the constructor.
  bool is_open() const { return is_open_; }
  const std::string& section() const { return section_; }

  // Begins the section that `line` names.  REQUIRES: `line` starts with '['.
  void Enter(const RecordLine& line);

 private:
  void CheckSpelling(const FilePosition& place, const std::string& name);

  const std::string_view design_;
  std::vector<Diagnostic>* const diagnostics_;
  bool is_open_ = true;  // true at first: lines before the first section are for every robot
  std::string section_;
};

void SectionFilter::Enter(const RecordLine& line) {
  ASSERT(!line.words.empty() && line.words[0].text[0] == '[', "{}", line.place.text);
  const std::string_view text = std::string_view(line.place.text).substr(line.place.column);
  const size_t end = text.find(']');
  const std::string name(Trim(text.substr(0, end)));
  if (end == std::string_view::npos) {
    diagnostics_->push_back(ErrorAt(
        line.place, fmt::format("section header without ']'; write [{}] (read so here)", name)));
  } else if (!Trim(text.substr(end + 1)).empty()) {
    const size_t after = text.find_first_not_of(" \t", end + 1);
    diagnostics_->push_back(
        ErrorAt(AtColumn(line.place, line.place.column + 1 + static_cast<int>(after)),
                "nothing may follow a section header; write this on a line of its own"));
  }
  section_ = name;
  if (name.empty()) {
    diagnostics_->push_back(
        ErrorAt(line.place, "section without a robot design; its records are skipped"));
    is_open_ = false;
    return;
  }
  CheckSpelling(line.place, name);
  is_open_ = design_ == kEveryDesign || EqualsIgnoringCase(name, design_);
}

void SectionFilter::CheckSpelling(const FilePosition& place, const std::string& name) {
  const std::optional<std::string> known = ClosestMatch(name, kKnownDesigns);
  if (!known) return;
  if (EqualsIgnoringCase(name, *known)) {
    diagnostics_->push_back(WarningAt(
        place, fmt::format("section [{0}] is read as [{1}]; write [{1}], the robot may not ignore "
                           "case",
                           name, *known)));
  } else {
    diagnostics_->push_back(WarningAt(
        place, fmt::format("no robot design '{}' is known; did you mean '{}'?", name, *known)));
  }
}

// Returns whether a line has a control byte, and reports the first one, because no text file of a
// stick has control bytes on purpose.  Comments are not checked: comments in Japanese may contain
// any byte.
bool HoldsControlByte(const FilePosition& place, std::vector<Diagnostic>* diagnostics) {
  for (size_t i = 0; i < place.text.size(); ++i) {
    const unsigned char byte = static_cast<unsigned char>(place.text[i]);
    if ((byte >= 0x20 && byte != 0x7f) || byte == '\t') continue;
    diagnostics->push_back(
        ErrorAt(AtColumn(place, static_cast<int>(i) + 1),
                fmt::format("byte {:#04x} in a record; only text, blanks and tabs are allowed",
                            static_cast<unsigned>(byte))));
    return true;
  }
  return false;
}

}  // namespace

std::vector<Word> SplitWords(std::string_view text) {
  std::vector<Word> words;
  size_t i = 0;
  while (i < text.size()) {
    if (IsBlank(text[i])) {
      ++i;
      continue;
    }
    const size_t start = i;
    while (i < text.size() && !IsBlank(text[i])) ++i;
    words.push_back({std::string(text.substr(start, i - start)), static_cast<int>(start) + 1});
  }
  return words;
}

std::vector<FilePosition> SplitLines(const std::string& file, std::string_view text,
                                     std::vector<Diagnostic>* diagnostics) {
  std::vector<FilePosition> lines;
  FilePosition first_binary;
  int binary_count = 0;
  int number = 0;
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    text.remove_prefix(kByteOrderMark.size());
    diagnostics->push_back(
        WarningAt(FilePosition{file, 0, 0, ""},
                  "starts with a UTF-8 byte order mark, which the robot would read as part of the "
                  "first line; save it without"));
  }
  while (!text.empty()) {
    const std::string_view line = TakeLine(&text);
    number += 1;
    if (line.find('\0') != std::string_view::npos) {
      if (binary_count == 0) first_binary = FilePosition{file, number, 0, "(not shown)"};
      binary_count += 1;
    } else if (line.size() > static_cast<size_t>(kLineBytesMax)) {
      const std::string start = std::string(line.substr(0, kQuotedBytesMax)) + "...";
      diagnostics->push_back(ErrorAt(
          FilePosition{file, number, 0, start},
          fmt::format("line of {} bytes, the limit is {}; skipped", line.size(), kLineBytesMax)));
    } else {
      lines.push_back(FilePosition{file, number, 1, std::string(line)});
    }
  }
  if (binary_count > 0) {
    diagnostics->push_back(ErrorAt(
        first_binary,
        fmt::format("NUL byte in the line; skipped{}; is this a binary or a UTF-16 file?",
                    binary_count == 1 ? "" : fmt::format(", as {} more", binary_count - 1))));
  }
  return lines;
}

namespace {

// Removes a comment behind the other words of a line, with a warning, because no source says how
// the robot reads such a comment.
void DropTrailingComment(RecordLine* line, std::vector<Diagnostic>* diagnostics) {
  for (size_t i = 1; i < line->words.size(); ++i) {
    if (line->words[i].text[0] != '#') continue;
    diagnostics->push_back(WarningAt(
        line->At(line->words[i]),
        "a comment has a line of its own; this one is not read here, the robot may take it for a "
        "part of the record"));
    line->words.resize(i);
    return;
  }
}

}  // namespace

std::vector<RecordLine> ReadRecords(const std::string& file, std::string_view text,
                                    std::string_view design, std::vector<Diagnostic>* diagnostics) {
  std::vector<RecordLine> records;
  SectionFilter sections(design, diagnostics);
  for (const FilePosition& place : SplitLines(file, text, diagnostics)) {
    RecordLine line{place, SplitWords(place.text), sections.section()};
    if (line.words.empty() || line.words[0].text[0] == '#') continue;
    line.place.column = line.words[0].column;
    if (line.words[0].text[0] == '[') {
      sections.Enter(line);
    } else if (sections.is_open() && !HoldsControlByte(line.place, diagnostics)) {
      DropTrailingComment(&line, diagnostics);
      records.push_back(std::move(line));
    }
  }
  return records;
}

bool MayBothApply(std::string_view section, std::string_view other) {
  return section.empty() || other.empty() || EqualsIgnoringCase(section, other);
}

}  // namespace openr_host
