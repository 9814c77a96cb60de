//
// ReadStickFile(): reads a whole file of the Memory Stick.
// IsStickFolder(): tells folders from files.
//

#ifndef StickFile_h_DEFINED
#define StickFile_h_DEFINED

#include <string>
#include <vector>

#include "FixedTypes.h"

// Largest file that is read, in bytes.  The limit is far above the largest known motion, which has
// 10 KB, and far below the robot's memory of 32 MB.
const long STICK_FILE_MAX = 1024 * 1024;

// Returns whether `path` ("/MS/OPEN-R/...") is a folder.
bool IsStickFolder(const std::string& path);

// Reads the file `path` ("/MS/OPEN-R/...") into `bytes`.  On failure, returns false, sets `error`
// to the reason and leaves `bytes` empty.
bool ReadStickFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error);

#endif  // StickFile_h_DEFINED
