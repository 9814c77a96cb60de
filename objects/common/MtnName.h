//
// Names of motion files on the Memory Stick.
//

#ifndef MtnName_h_DEFINED
#define MtnName_h_DEFINED

#include <string>

// Size of a buffer for the name of a motion file, in bytes.
const int MTN_NAME_SIZE = 16;
// Checks that `given` is an 8+3 file name without a path, and writes it to `name`, in upper case; the
// rest of `name` is filled with zero bytes.  When `given` is not such a name, returns false and sets
// `error` to the reason (Hohl 2004, 5.3.7).
bool MtnFileName(const char* given, char name[MTN_NAME_SIZE], std::string* error);

// The folder of motions on the Memory Stick (Hohl 2004, 5.3.7).
#define MTN_DIRECTORY "/MS/OPEN-R/MW/DATA/P/"

#endif  // MtnName_h_DEFINED
