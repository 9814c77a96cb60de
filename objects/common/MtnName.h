//
// Names of motion files on the Memory Stick.
//

#ifndef MtnName_h_DEFINED
#define MtnName_h_DEFINED

#include <string>

// Checks a bare 8+3 file name and writes it in upper case, zero-padded, to `name`.
// Returns false with a reason in `error` when it is none (Hohl 2004, 5.3.7).
const int MTN_NAME_SIZE = 16;
bool MtnFileName(const char* given, char name[MTN_NAME_SIZE], std::string* error);

// Where motions lie on the Memory Stick (Hohl 2004, 5.3.7).
#define MTN_DIRECTORY "/MS/OPEN-R/MW/DATA/P/"

#endif  // MtnName_h_DEFINED
