// Splits a text file of a Memory Stick into lines and words.  All these files have the same form.
//
// Lines end in LF or CR LF, which may be missing after the last line.  Blanks and tabs separate
// words and may follow the last word.  A line that begins with '#' is a comment.  A comment after
// the words of a line is skipped with a warning, because no source says that the robot allows such
// a comment.  "[ERS-210]" alone on a line opens a section for that robot design; lines before the
// first section are valid for every robot.  (Programmer's Guide 4.2, and the configuration files of
// Sony's samples, 16 of which have CR LF.)
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// The longest line of a text file that parsers read, in bytes; our own limit.  It is ample, because
// the longest useful line has two service names of 127 characters.
inline constexpr int kLineBytesMax = 1024;

// A value for the parameter `design` of parsers, in place of a robot design such as "ERS-210".  It
// selects the lines of all sections of a file.
inline constexpr std::string_view kEveryDesign = "*";

struct Word {
  std::string text;  // never empty
  int column = 0;    // counted from 1
};

// Returns the words of `text`, which blanks and tabs separate.
std::vector<Word> SplitWords(std::string_view text);

// Returns the lines of a file in order, each as a position with column 1.  A line with NUL bytes or
// of more than kLineBytesMax bytes is left out and reported.  NUL bytes are reported once for the
// whole file, because a binary file has thousands.  A UTF-8 byte order mark is dropped with a
// warning.
std::vector<FilePosition> SplitLines(const std::string& file, std::string_view text,
                                     std::vector<Diagnostic>* diagnostics);

struct RecordLine {
  FilePosition place;       // position of the first word
  std::vector<Word> words;  // never empty
  // Name of the section that contains this line (a robot design), as the file writes it; "" before
  // the first section.
  std::string section;

  FilePosition At(const Word& word) const { return AtColumn(place, word.column); }
};

// Returns the lines of a file, without comments and empty lines, that are valid for the robot
// design `design` ("ERS-210", or kEveryDesign).  Section names are compared without regard to case,
// with a warning if the case differs.  In sections of other designs only the line that begins the
// section is checked.
std::vector<RecordLine> ReadRecords(const std::string& file, std::string_view text,
                                    std::string_view design, std::vector<Diagnostic>* diagnostics);

// Returns true if a robot can read both sections of a text file: their names are equal, or one name
// is "", the name for the lines before the first section, which every robot reads.
bool MayBothApply(std::string_view section, std::string_view other);

}  // namespace openr_host
