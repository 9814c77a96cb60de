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

// Ends with { UNDEF, (Entry)ENTRY_UNDEF }.  Visible outside the image: the
// loader looks it up by name.
extern ObjectEntry ObjectEntryTable[] __attribute__((visibility("default")));

// Run once at load; the host's loader has run the constructors before it.
extern "C" void Prologue(InitInfo* info);

#endif  // OPENR_OBJECTENTRYTABLE_H_INCLUDED
