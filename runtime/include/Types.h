// The integer types of the OPEN-R interface, with the widths they have on the robot.
//
// On the robot `long` has 32 bits, and the robot's headers use it for longword and int32.  Here
// these names are `int`, which has 32 bits on the robot, on a 64-bit host and on any MIPS.  The
// width must be the same everywhere, because sources read these types from files and print them
// with %d and %x. sbyte and int8 are `signed char`, because plain char is signed on the robot.
//
// `byte` is a global name.  A source with "using namespace std;" must be compiled as C++14 or
// older, because since C++17 std::byte makes the name ambiguous.
#ifndef OPENR_TYPES_H_INCLUDED
#define OPENR_TYPES_H_INCLUDED

#include <stddef.h>
#include <sys/types.h>  // for u_char, u_short, u_int, u_long

typedef unsigned char byte;
typedef unsigned short word;
typedef unsigned int longword;
typedef signed char sbyte;
typedef short sword;
typedef int slongword;

typedef byte* pbyte;
typedef word* pword;
typedef int* plongword;

typedef signed char int8;
typedef unsigned char uint8;
typedef short int16;
typedef unsigned short uint16;
typedef int int32;
typedef unsigned int uint32;

// int64 and uint64 have 32 bits despite their names, because the robot's header defines them with
// `long`.
typedef int int64;
typedef unsigned int uint64;

typedef unsigned int magicword;
typedef bool Boolean;

// The type with the strictest alignment: 8 bytes on the robot, more on most hosts.
typedef long double AlignedBlock;

// The result of a function of Aperios, the robot's operating system; the values are in sError.h.
typedef slongword sError;

// The number of an entry of an object, 0..63; it selects the function that receives a message.
typedef longword Selector;
const Selector UNDEF = 0xffffffff;

// The function in an entry of an object's table (ObjectEntryTable.h).
typedef void (*Entry)(...);

typedef byte* VirtualAddress;
typedef void* PhysicalAddress;

// The id and the access rights of shared memory (NewSharedMemoryRegion() and similar functions).
// Programs cast a MemoryRegionID* to ODesignDataID*, which points to a longword.  So the id must be
// as wide as a longword.
typedef unsigned int MemoryRegionID;
typedef MemoryRegionID SharedMemoryRegionID;

enum MemoryProtectionInfo {
  MEMPROTINFO_INVALID = 0,
  MEMPROTINFO_R = 1,  // read only
  MEMPROTINFO_RW = 2  // read and write
};
typedef MemoryProtectionInfo SharedMemoryProtectionInfo;

// Structures of the system that applications can name but not use.  The robot's header calls them
// Context, EntryTable, Thread, Object and ExecSpace.  Here they have a prefix, so that programs can
// use these common names themselves.
typedef struct AperiosContext* CName;
typedef struct AperiosEntryTable* EntryTableID;
typedef struct AperiosThread* ThreadID;
typedef struct AperiosObject* ObjectPtr;
typedef struct AperiosExecSpace* ExecSpaceID;

// On the robot FALSE is NULL, which is 0 there.  Here FALSE is the number 0, because other
// compilers warn if a NULL is assigned to an int.
#ifndef NULL
#define NULL 0
#endif
#ifndef TRUE
#define TRUE (!0)
#endif
#ifndef FALSE
#define FALSE 0
#endif

#include <sError.h>

#endif  // OPENR_TYPES_H_INCLUDED
