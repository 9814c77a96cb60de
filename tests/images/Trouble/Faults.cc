#include "Faults.h"

#include <MCOOP.h>
#include <OPENR/RCRegion.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static volatile double number;
static volatile double zero = 0;
static volatile int whole;

class Victim {
public:
    virtual ~Victim() {}
    void Set(int value) { value_ = value; }

private:
    int value_;
};

static Victim* volatile nobody = 0;

static void
ConvertConstant()
{
    whole = (int)1e10;  // compilers know the result, and leave no conversion in
}

static void
ConvertToUnsigned()
{
    number = -1.0;
    whole = (int)(unsigned int)number;  // no fault on the robot
    number = 300.0;
    whole = (unsigned char)number;      // nor is this
}

static void
AccessUnaligned()
{
    static char buffer[16];
    char* volatile odd = buffer + 1;
    *(int*)odd = 5;
    whole = *(int*)odd;
}

// Where the robot's pointers have 4 bytes, structures of them lie at multiples of 4.
struct Node {
    Node* next;
    int value;
};

static void
AccessByFour()
{
    static double room[4];
    char* volatile four = (char*)room + 4;
    ((Node*)four)->next = 0;
    whole = ((Node*)four)->value;
}

static void
ExecuteData()
{
    static int data[] = {0x0000000d, 0x0000000d};  // an instruction of the robot
    void (*volatile function)() = (void (*)())data;
    function();
    whole = 1;  // not the last thing that is done: a call, not a jump
}

static void
DivideByConstantZero()
{
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
    const int nothing = 0;
    const int result = 1 / nothing;  // compilers leave out what nobody uses; the robot's did not
#pragma GCC diagnostic pop
    (void)result;
}

// Divides the smallest integers by -1, and prints quotients and remainders.
static void
DivideSmallest()
{
    static volatile int minusOne = -1;
    volatile int smallest = INT_MIN;
    volatile long long longest = LLONG_MIN, longMinusOne = -1;
    const int quotient = smallest / minusOne, remainder = smallest % minusOne;
    printf("quotients %d %lld, remainders %d %lld\n", quotient, longest / longMinusOne, remainder,
           longest % longMinusOne);
}

// The bytes are those of a NaN, as a message or a file may have them.
static void
PrintNaN()
{
    const int bits = 0x7fc00000;
    float value;
    memcpy(&value, &bits, sizeof value);
    char text[40];
    sprintf(text, "%f", value);
    whole = text[0];
}

// The bytes are those of an int that is taken for a float.
static void
UseDenormal()
{
    const int bits = 1234;
    float value;
    memcpy(&value, &bits, sizeof value);
    volatile float factor = value;  // the compiler does not know it
    number = factor * 2.0f;
}

// A constructor of the image makes these numbers.  The last ones are too small for a float.
class Table {
public:
    Table()
    {
        for (int i = 0; i < SIZE; i++) values[i] = (float)exp(-i - zero);
    }
    double Sum() const
    {
        double sum = 0;
        for (int i = 0; i < SIZE; i++) sum += values[i];
        return sum;
    }

private:
    enum { SIZE = 100 };
    float values[SIZE];
};

static Table table;

// Makes numbers that are too small for a double, without loss of a bit and with it, and uses them.
// They are 0 on the robot.
static void
UseSmallResults()
{
    number = DBL_MIN;
    for (int i = 0; i < 10; i++) number = number * 0.5;
    if (number != 0) abort();
    number = DBL_MIN * 1.7;
    for (int i = 0; i < 10; i++) number = number * 0.9;
    if (number != 0) abort();
    number = table.Sum();
}

static void
LeakRegions()
{
    for (;;) {
        RCRegion* region = new RCRegion(4);
        if (region->Base() == 0) return;
    }
}

static void
TouchBreakpoint()
{
#if defined(__x86_64__)
    asm volatile("int3");
#else
    raise(SIGTRAP);
#endif
    whole = 1;  // not the last thing that is done
}

// Asks for more shared memory than the robot has.
static void
MakeHugeRegion()
{
    RCRegion* region = new RCRegion((32 << 20) + 1);
    if (region->Base() != 0) abort();
    region->RemoveReference();
}

static void
DeleteRegionTwice()
{
    void* base;
    if (NewRegion(100, &base) != sSUCCESS) abort();
    DeleteRegion(base);
    if (DeleteRegion(base) == sSUCCESS) abort();
}

static void
LeakMemory()
{
    while (malloc(1 << 20) != 0) whole++;
}

// Frees memory of the C library twice: fclose() has freed the memory of the stream.
static void
FreeStream()
{
    FILE* volatile file = fopen("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", "r");
    fclose(file);
    free(file);
    whole = 1;
}

void
MakeFault(const char* word)
{
    if (strcmp(word, "nan") == 0) {
        number = zero / zero;
    } else if (strcmp(word, "nanlib") == 0) {
        number = log(zero - 1);
    } else if (strcmp(word, "nanprint") == 0) {
        PrintNaN();
    } else if (strcmp(word, "denormal") == 0) {
        UseDenormal();
    } else if (strcmp(word, "small") == 0) {
        UseSmallResults();
    } else if (strcmp(word, "smallfirst") == 0) {
        UseSmallResults();
        UseDenormal();
    } else if (strcmp(word, "infinity") == 0) {
        number = 1 / zero;
    } else if (strcmp(word, "convert") == 0) {
        number = 1e10;
        whole = (int)number;
    } else if (strcmp(word, "constant") == 0) {
        ConvertConstant();
    } else if (strcmp(word, "unsigned") == 0) {
        ConvertToUnsigned();
    } else if (strcmp(word, "unaligned") == 0) {
        AccessUnaligned();
    } else if (strcmp(word, "four") == 0) {
        AccessByFour();
    } else if (strcmp(word, "execute") == 0) {
        ExecuteData();
    } else if (strcmp(word, "nullmethod") == 0) {
        nobody->Set(1);
    } else if (strcmp(word, "wild") == 0) {
        *(volatile int*)0x12345678 = 1;
    } else if (strcmp(word, "wildfar") == 0) {
        *(volatile int*)(~0UL / 0xff * 0x70) = 1;  // 0x7070..., no address of an x86-64 processor
    } else if (strcmp(word, "zero") == 0) {
        DivideByConstantZero();
    } else if (strcmp(word, "smallest") == 0) {
        DivideSmallest();
    } else if (strcmp(word, "regions") == 0) {
        LeakRegions();
    } else if (strcmp(word, "memory") == 0) {
        LeakMemory();
    } else if (strcmp(word, "hugeregion") == 0) {
        MakeHugeRegion();
    } else if (strcmp(word, "deletetwice") == 0) {
        DeleteRegionTwice();
    } else if (strcmp(word, "breakpoint") == 0) {
        TouchBreakpoint();
    } else if (strcmp(word, "damage") == 0) {
        FreeStream();
    } else if (strcmp(word, "endsystem") == 0) {
        syscall(SYS_exit_group, 0);
    }
}
