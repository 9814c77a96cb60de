#include "TextFormat.h"

#include <stdarg.h>
#include <stdio.h>

std::string
TextFormat(const char* format, ...)
{
    char text[240];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof(text), format, arguments);
    va_end(arguments);
    text[sizeof(text) - 1] = '\0';
    return text;
}
