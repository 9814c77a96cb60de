// Parses DESIGNDB.CFG, which lists the files that OPENR::FindDesignData finds by keyword.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// The length of the longest keyword in DESIGNDB.CFG: odesignkeywordNAME_MAX of <OPENR/OPENR.h>,
// without the closing NUL.
inline constexpr int kDesignKeywordBytesMax = 127;

struct DesignRecord {
  std::string keyword;  // keywords that differ in upper or lower case are different
  // The path of the file with the data for the keyword, as DESIGNDB.CFG has it, e.g.
  // /MS/OPEN-R/MW/DATA/P/BOW.MTN.  Paths that differ only in upper and lower case name the same
  // file.
  std::string path;
  std::string section;  // the robot design for which the line is valid; "" for every robot
  FilePosition keyword_place;
  FilePosition path_place;
};

struct DesignConfig {
  std::vector<DesignRecord> designs;  // in the order of the file
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of DESIGNDB.CFG, one "keyword path" per line, for one robot design ("ERS-210", or
// kEveryDesign).  A bad line is reported and skipped; all other lines are used.  A keyword given
// twice keeps its first path, with a warning.  This is our choice, because no source says which
// path the robot takes.
DesignConfig ParseDesignConfig(const std::string& file, std::string_view text,
                               std::string_view design);

}  // namespace openr_host
