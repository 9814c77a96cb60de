// The integer types of the OPEN-R interface, with the widths they have on the robot.
//
// The robot's compiler gives `long` 32 bits and its headers use it for longword and
// int32.  Here those names are `int`, which has 32 bits on the robot, on a 64-bit host
// and on any MIPS: sources overlay these types on files and print them with %d and %x.
// sbyte and int8 are `signed char` because plain char is signed on the robot.
//
// `byte` is a global name.  A source with "using namespace std;" therefore has to be
// compiled below C++17, where std::byte would make it ambiguous.
#ifndef OPENR_TYPES_H_INCLUDED
#define OPENR_TYPES_H_INCLUDED

#include <stddef.h>
#include <sys/types.h>  // u_char, u_short, u_int, u_long

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

// Despite their names these are 32 bits wide: the robot's header says `long`.
typedef int int64;
typedef unsigned int uint64;

typedef unsigned int magicword;
typedef bool Boolean;

// The type with the strictest alignment; 8 bytes on the robot, the host's width here.
typedef long double AlignedBlock;

// Result of an Aperios call; the values are in sError.h.
typedef slongword sError;

// Number of an entry of an object, 0..63; it says which function a message is for.
typedef longword Selector;
const Selector UNDEF = 0xffffffff;

// An entry of an object's table.
typedef void (*Entry)(...);

typedef byte* VirtualAddress;
typedef void* PhysicalAddress;

// Names and access rights of shared memory regions (NewSharedMemoryRegion and its kin).
// This type is as wide as a longword, because programs cast a MemoryRegionID* to ODesignDataID*.
typedef unsigned int MemoryRegionID;
typedef MemoryRegionID SharedMemoryRegionID;

enum MemoryProtectionInfo {
  MEMPROTINFO_INVALID = 0,
  MEMPROTINFO_R = 1,  // read only
  MEMPROTINFO_RW = 2  // read and write
};
typedef MemoryProtectionInfo SharedMemoryProtectionInfo;

// System structures that an application can name and never look into.  The robot's header
// calls them Context, EntryTable, Thread, Object and ExecSpace; such plain names would take
// them away from everybody, so here they carry a prefix.
typedef struct AperiosContext* CName;
typedef struct AperiosEntryTable* EntryTableID;
typedef struct AperiosThread* ThreadID;
typedef struct AperiosObject* ObjectPtr;
typedef struct AperiosExecSpace* ExecSpaceID;

// FALSE is the robot's NULL, which is 0.  Spelled as a number it can be assigned to an
// int without a warning from compilers whose NULL is more than a number.
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
