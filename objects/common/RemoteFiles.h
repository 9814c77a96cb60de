//
// Requests and answers of the remote control that are about files of the Memory Stick; they need
// version 2 of the protocol (docs/remote-control.md).
//

#ifndef RemoteFiles_h_DEFINED
#define RemoteFiles_h_DEFINED

#include <string>
#include <vector>

#include "FixedTypes.h"
#include "RemotePacket.h"

enum RcFileKind { rcfileMOTION = 0, rcfileIMAGE = 1, NUM_RC_FILE_KINDS };

// Size of the largest motion that can be uploaded, in bytes.  JointMover plays no larger motion
// (StickFile.h).
const Uint32 RC_MAX_MOTION = 1024 * 1024;

// Size of the largest image that can be uploaded, in bytes.  This is enough: images of the host
// have less than 1 MB, images of the robot less than 300 KB.
const Uint32 RC_MAX_IMAGE = 8 * 1024 * 1024;

// Largest number of bytes of a file that a request UPLOAD_DATA can carry.
const int RC_MAX_UPLOAD_DATA = RC_MAX_PACKET - RC_HEADER_SIZE - 4;

// Largest number of bytes of a file that an answer to DOWNLOAD can carry.
const int RC_MAX_DOWNLOAD_DATA = RC_MAX_PACKET - RC_ANSWER_HEADER_SIZE - 4;

// Name of the one image that may be uploaded and downloaded.
#define RC_IMAGE_NAME "CONTROLL.BIN"

struct RcListEntry {
    std::string name;
    Uint32 size;
};

// A part of the list of motions on the stick, as an answer of the remote control.
struct RcList {
    Uint16 total;  // number of motions on the stick
    Uint16 first;  // index of the first entry of this part
    std::vector<RcListEntry> entries;

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

// Largest number of motions in one answer to MTN_LIST, which lists the motions in parts.  A packet
// has room for 59 motions with names of 12 characters, so 50 motions always fit.
const int RC_MAX_LIST_ENTRIES = 50;

struct RcUploadBegin {
    Uint8 kind;  // a value of RcFileKind
    std::string name;
    Uint32 size;
    Uint32 crc;  // CRC-32 of the whole file

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

struct RcFileName {
    Uint8 kind;  // a value of RcFileKind
    std::string name;

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

struct RcDownload {
    Uint8 kind;  // a value of RcFileKind
    std::string name;
    Uint32 offset;

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

#endif  // RemoteFiles_h_DEFINED
