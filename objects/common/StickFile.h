//
// A whole file of the Memory Stick in memory.
//

#ifndef StickFile_h_DEFINED
#define StickFile_h_DEFINED

#include <string>
#include <vector>

#include "FixedTypes.h"

// Far more than a motion needs (the largest known has 10 KB), little beside 32 MB of RAM.
const long STICK_FILE_MAX = 1024 * 1024;

// Reads `path` ("/MS/OPEN-R/...").  Returns false with a reason in `error`; `bytes` is
// empty then.
bool ReadStickFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error);

#endif  // StickFile_h_DEFINED
