//
// What Talker sends and Listener gets.
//
// Sender and receiver are separate programs: what they share is bytes.  So no pointers, no
// std::string, nothing virtual, and both include this one file.
//

#ifndef Line_h_DEFINED
#define Line_h_DEFINED

#include <Types.h>

const size_t LINE_SIZE = 32;

struct Line {
    longword number;       // from 1
    char text[LINE_SIZE];  // with a zero at its end
};

#endif  // Line_h_DEFINED
