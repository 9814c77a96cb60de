// The macro that makes the functions of an object callable for the system.
#ifndef OPENR_APSYS_H_INCLUDED
#define OPENR_APSYS_H_INCLUDED

#include <Types.h>

// Defines ENTRYNAME, a function for an object's table of entries (ObjectEntryTable), which calls
// the extern "C" function FUNNAME with the address of the message.
#define GEN_ENTRY(ENTRYNAME, FUNNAME)                              \
  extern "C" void ENTRYNAME(void* msg) __attribute__((used));      \
  extern "C" void openr_call_##ENTRYNAME(void*) __asm__(#FUNNAME); \
  extern "C" void ENTRYNAME(void* msg) { openr_call_##ENTRYNAME(msg); }

#endif  // OPENR_APSYS_H_INCLUDED
