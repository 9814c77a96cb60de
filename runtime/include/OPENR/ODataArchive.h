// The format of archives of motions and sounds (.ODA files), in memory and on the stick.
//
// Numbers are little-endian.  A file is a header, a directory of numEntries entries, then the
// members (motions or sounds) without gaps.  The SDK's functions for reading archives are not
// known, so only programs that do not call them compile.
#ifndef OPENR_ODATAARCHIVE_H_INCLUDED
#define OPENR_ODATAARCHIVE_H_INCLUDED

#include <Types.h>

// The id of an open .ODA file (an archive of motions or sounds), and the largest number of such
// files that are open at a time.
typedef longword ODataArchiveID;
const ODataArchiveID odaID_UNDEF = 0xffffffff;
const size_t odaMAX_SIZE = 32;

// The first four bytes of an .ODA file (an archive of motions or sounds) and of its members, as one
// number.
typedef longword ODataArchiveMagic;
const ODataArchiveMagic odamagicUNDEF = 0xffffffff;
const ODataArchiveMagic odamagicODAR = 0x5241444f;
const ODataArchiveMagic odamagicOMTN = 0x4e544d4f;
const ODataArchiveMagic odamagicOSND = 0x444e534f;
const ODataArchiveMagic odamagicWAVE = 0x45564157;
const ODataArchiveMagic odamagicMIDI = 0x4944494d;
const ODataArchiveMagic odamagicLED = 0x44454c;
const ODataArchiveMagic odamagicSYN = 0x4e5953;
const ODataArchiveMagic odamagicSTT = 0x545453;

namespace ODataArchive {

// The header of an .ODA file, which is an archive of motions or sounds; 64 bytes.
struct Header {
  char magic[4];      // the text "ODAR"
  word majorVersion;  // the number 0
  word minorVersion;  // the number 3
  longword numEntries;
  longword entrySize;  // size of a directory entry in bytes, 144
  byte padding[48];    // filled with zeros
};

// An entry of the directory of an .ODA file (an archive of motions or sounds), which describes one
// member of the archive; 144 bytes.
struct Entry {
  char type[4];     // kind of data: "OMTN", "WAVE", "MIDI", "OSND", "LED", "SYN"; padded with zeros
  char name[128];   // padded with zeros
  longword offset;  // place of this archive member, in bytes from the start of the file
  longword size;    // size of this archive member in bytes
  longword padding;
};

}  // namespace ODataArchive

#endif  // OPENR_ODATAARCHIVE_H_INCLUDED
