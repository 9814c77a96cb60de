#include "MtnName.h"

#include <ctype.h>
#include <string.h>

static bool
IsNameCharacter(char c)
{
    return isalnum((unsigned char)c) || strchr("_-~!#$%&()@^{}", c) != 0;
}

bool
MtnFileName(const char* given, char name[MTN_NAME_SIZE], std::string* error)
{
    memset(name, 0, MTN_NAME_SIZE);
    int base = 0;
    int extension = -1;  // length of the extension; -1 until the dot is found
    int length = 0;
    for (const char* c = given; *c != '\0'; c++) {
        const bool isDot = *c == '.';
        if (isDot && extension < 0 && base > 0)
            extension = 0;
        else if (isDot || !IsNameCharacter(*c))
            break;
        else if (extension < 0)
            base++;
        else
            extension++;
        if (base > 8 || extension > 3) break;
        name[length++] = (char)toupper((unsigned char)*c);
    }
    if (given[length] == '\0' && base > 0 && extension != 0) {
        if (extension > 0) return true;
        *error = "'" + std::string(given) + "' has no extension; a motion file is called NAME.MTN";
    } else {
        *error = "'" + std::string(given).substr(0, 80) +
                 "' is no bare 8+3 file name; write NAME.MTN without a path";
    }
    memset(name, 0, MTN_NAME_SIZE);
    return false;
}
