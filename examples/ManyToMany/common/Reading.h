//
// The data that both instruments send.
//

#ifndef Reading_h_DEFINED
#define Reading_h_DEFINED

#include <Types.h>

const size_t READING_NAME_SIZE = 16;

struct Reading {
    char name[READING_NAME_SIZE];  // name of the instrument
    slongword value;
};

#endif  // Reading_h_DEFINED
