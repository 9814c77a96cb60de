// Lines and words: what all text files of a Memory Stick have in common.
//
// Lines end in LF or CR LF, the last one perhaps in nothing; blanks and tabs separate words and
// may trail.  '#' as the first character of a line makes it a comment; after a record no source
// knows one: it is a warning, and not read.  "[ERS-210]" alone on a line opens a section for that
// robot design; records before the first section are for every robot.  (Programmer's Guide 4.2, and
// the configuration files of Sony's samples, 16 of which have CR LF.)
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// Our own limit.  Two service names of 127 characters are the longest record that makes sense.
inline constexpr int kLineBytesMax = 1024;

// Stands for "the records of every section" where a robot design is asked for.
inline constexpr std::string_view kEveryDesign = "*";

struct Word {
  std::string text;  // never empty
  int column = 0;    // from 1
};

// The words of `text`: what blanks and tabs separate.
std::vector<Word> SplitWords(std::string_view text);

// The lines of a file, in order, each a Place with column 1.  Lines with NUL bytes or of more than
// kLineBytesMax bytes are left out and reported (NULs once for the whole file, since a binary has
// thousands); a UTF-8 byte order mark is dropped with a warning.
std::vector<FilePosition> SplitLines(const std::string& file, std::string_view text,
                                     std::vector<Diagnostic>* diagnostics);

struct RecordLine {
  FilePosition place;       // column of the first word
  std::vector<Word> words;  // never empty
  std::string section;      // as written, "" before the first section

  FilePosition At(const Word& word) const { return AtColumn(place, word.column); }
};

// The records of a file with sections that hold for `design` ("ERS-210", or kEveryDesign).
// Section names are compared without regard to case, with a warning when the case differs.
// Lines of other designs are not looked at beyond their section header.
std::vector<RecordLine> ReadRecords(const std::string& file, std::string_view text,
                                    std::string_view design, std::vector<Diagnostic>* diagnostics);

// True iff there is a robot for which records of both sections hold.
bool MayHoldTogether(std::string_view section, std::string_view other);

}  // namespace openr_host
