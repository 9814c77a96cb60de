// Archives of motions and sounds (.ODA files), as they lie in memory or on the stick.
//
// Numbers are little endian.  A file is a header, a directory of numEntries entries, then
// the members without gaps.  The SDK's functions for reading archives are not known to us;
// programs that only include this header compile.
#ifndef OPENR_ODATAARCHIVE_H_INCLUDED
#define OPENR_ODATAARCHIVE_H_INCLUDED

#include <Types.h>

namespace ODataArchive {

// 64 bytes.
struct Header {
  char magic[4];      // "ODAR"
  word majorVersion;  // 0
  word minorVersion;  // 3
  longword numEntries;
  longword entrySize;  // bytes of a directory entry, 144
  byte padding[48];    // zero
};

// 144 bytes.
struct Entry {
  char type[4];     // "OMTN", "WAVE", "MIDI", "OSND", "LED", "SYN"; short ones end in zero
  char name[128];   // zero padded
  longword offset;  // of the member, from the start of the file
  longword size;    // of the member, bytes
  longword padding;
};

}  // namespace ODataArchive

#endif  // OPENR_ODATAARCHIVE_H_INCLUDED
