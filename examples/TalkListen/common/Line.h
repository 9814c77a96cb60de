//
// The data that Talker sends to Listener.
//
// Sender and receiver are separate programs, and only bytes are passed between them.  So the struct
// has no pointers, no std::string and no virtual functions, and both programs include this file.
//

#ifndef Line_h_DEFINED
#define Line_h_DEFINED

#include <Types.h>

const size_t LINE_SIZE = 32;

struct Line {
    longword number;       // counted from 1
    char text[LINE_SIZE];  // with a zero at its end
};

#endif  // Line_h_DEFINED
