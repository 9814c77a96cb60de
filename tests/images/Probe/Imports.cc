#include "Imports.h"

#include <MCOOP.h>
#include <OPENR/OPENR.h>
#include <OPENR/RCRegion.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sstream>
#include <stdexcept>
#include <vector>

// Orders a message to the entry Tick of the object talker, half a second from now.
static void
OrderTick()
{
    OID talker;
    Find("talker", &talker);
    TimeEventInfoWithRelativeTime info(RelativeTime(0, 500));
    SetTimeEvent(&info, talker, oentryBASE + 5, 0, 0, 0);
}

// Keeps an address of the stack on which constructors of global objects run, and a region that such
// a constructor has made.
struct Early {
    Early() : place(0), region(0)
    {
        if (FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/REGION.TXT", "r")) {
            fclose(file);
            region = new RCRegion(32);
            strcpy(region->Base(), "made early");
        }
        if (FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/EVENT.TXT", "r")) {
            fclose(file);
            OrderTick();
        }
        if (FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/THROW.TXT", "r")) {
            fclose(file);
            throw std::runtime_error("thrown early");
        }
        place = __builtin_frame_address(0);
    }
    void* place;
    RCRegion* region;
};

static Early early;

static jmp_buf goBack;

static void __attribute__((noinline))
Jump(int value)
{
    longjmp(goBack, value);
}

static std::string
CatchFromTheLibrary()
{
    std::ostringstream out;
    std::vector<int> three(3);
    for (int i = 0; i < 3; i++) {
        try {
            out << three.at(static_cast<size_t>(2 + i)) << " ";
        } catch (const std::out_of_range&) {
            out << "caught ";
        }
    }
    return out.str();
}

static int
ByText(const void* a, const void* b)
{
    char left[20], right[20];
    sprintf(left, "%05d", *static_cast<const int*>(a));
    sprintf(right, "%05d", *static_cast<const int*>(b));
    return strcmp(left, right);
}

static std::string
Many()
{
    char text[600];
    snprintf(text, sizeof(text),
             "%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d "
             "%d %d %d %d %d %d %d %d %d %d %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f %.1f %s",
             1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27,
             28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5,
             9.5, 10.5, 11.5, "end");
    return text;
}

static std::string __attribute__((noinline))
Digits(int count)
{
    char format[20], text[600];
    sprintf(format, "%%.%dLf", count);
    snprintf(text, sizeof(text), format, 1e-3000L);
    return text;
}

typedef double (*Function)(double);
static const Function table[] = {floor, ceil};

std::string
AnswerImports(const std::string& command)
{
    std::ostringstream out;
    if (command == "constructed") out << early.place;
    if (command == "region") out << early.region->Base();
    if (command == "stack") out << static_cast<void*>(&out);
    if (command == "arguments") out << Many();
    if (command == "digits") out << Digits(4000);
    if (command == "catch") out << CatchFromTheLibrary();
    if (command == "jump") {
        const int came = setjmp(goBack);
        if (came == 0) Jump(7);
        out << "came with " << came;
    }
    if (command == "sort") {
        int numbers[] = {30, 4, 200, 1};
        qsort(numbers, 4, sizeof(numbers[0]), ByText);
        for (int i = 0; i < 4; i++) out << numbers[i] << " ";
    }
    if (command == "functions") {
        const Function again = floor;
        out << (table[0] == again) << (table[1] == again) << " " << table[0](2.5) << table[1](2.5);
    }
    return out.str();
}
