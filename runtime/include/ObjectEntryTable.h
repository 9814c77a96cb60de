// The table through which the system finds the entries of an object.
#ifndef OPENR_OBJECTENTRYTABLE_H_INCLUDED
#define OPENR_OBJECTENTRYTABLE_H_INCLUDED

#include <MCOOP.h>
#include <Types.h>

struct ObjectEntry {
  Selector selector;
  Entry entry;
};

#define ENTRY_UNDEF 0

// The table of an object's entries; it ends with { UNDEF, (Entry)ENTRY_UNDEF }.  It is visible
// outside of the image, because the loader looks it up by name.
extern ObjectEntry ObjectEntryTable[] __attribute__((visibility("default")));

// An entry of the object that runs once when the image is loaded, after the host's loader has run
// the constructors.
extern "C" void Prologue(InitInfo* info);

#endif  // OPENR_OBJECTENTRYTABLE_H_INCLUDED
