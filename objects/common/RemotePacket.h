//
// Packets of the remote control: the byte level of docs/remote-control.md.
//
// Used by RCServer on the robot and by the client on the host.  Every read and write is
// bounded; a packet that ends early leaves zeros and a flag, never a crash.
//

#ifndef RemotePacket_h_DEFINED
#define RemotePacket_h_DEFINED

#include <string>

#include "FixedTypes.h"

const int RC_PORT = 54000;
const Uint16 RC_MAGIC = 0x4352;  // the bytes 'R', 'C'
const int RC_VERSION = 1;

const int RC_HEADER_SIZE = 8;          // of a request
const int RC_ANSWER_HEADER_SIZE = 16;  // of an answer

// Bytes of a whole packet.  1024: the robot sends that much at once, more waits up to 200 ms
// (BBS 1530, 1592).
const int RC_MAX_PACKET = 1024;

// What both kinds of packet begin with, without magic.
struct RcHeader {
    Uint16 size;  // of the whole packet
    Uint8 version;
    Uint8 command;
    Uint16 tag;
};

// Puts numbers and strings behind each other into a buffer of the caller.
class RcWriter {
public:
    RcWriter(Uint8* buffer, int capacity);

    void U8(Uint32 value);
    void U16(Uint32 value);
    void U32(Uint32 value);
    void S32(Sint32 value) { U32((Uint32)value); }

    // A length byte and the characters; longer strings lose their end.  What is no printable ASCII
    // character goes out as '?'.
    void String(const std::string& text);

    int Size() const { return size_; }
    bool HasOverflowed() const { return hasOverflowed_; }

    // Goes back to `size` bytes.
    void Truncate(int size);

    // Writes the first RC_HEADER_SIZE bytes, now that the size is known.
    void PutHeader(int command, int tag);

private:
    bool Room(int count);

    Uint8* buffer_;
    int capacity_;
    int size_;
    bool hasOverflowed_;
};

class RcReader {
public:
    RcReader(const Uint8* bytes, int size) : bytes_(bytes), size_(size), at_(0), hasFailed_(false)
    {
    }

    Uint8 U8();
    Uint16 U16();
    Uint32 U32();
    Sint32 S32();
    std::string String();  // '?' for what is no printable ASCII character

    // Everything was there, and nothing is left over.
    bool IsComplete() const { return !hasFailed_ && at_ == size_; }
    bool HasFailed() const { return hasFailed_; }

private:
    bool Has(int count);

    const Uint8* bytes_;
    int size_;
    int at_;
    bool hasFailed_;
};

// Cuts a stream of bytes into packets, however it was delivered: in pieces, or several
// packets at once.
class RcFramer {
public:
    enum Result {
        NEEDS_MORE,  // no whole packet is here
        PACKET,
        BROKEN  // what is here is no packet; the stream cannot be followed any further
    };

    RcFramer() { Reset(); }
    void Reset();

    // How many bytes Take() has room for; at least RC_MAX_PACKET after NEEDS_MORE.
    int Room() const { return CAPACITY - size_; }

    // Appends bytes.  REQUIRES: size <= Room().
    void Take(const Uint8* bytes, int size);

    // The next packet.  What Header() and Payload() tell holds until the next call of Next() or
    // Take().
    Result Next();
    const RcHeader& Header() const { return header_; }
    const Uint8* Payload() const { return buffer_ + RC_HEADER_SIZE; }
    int PayloadSize() const { return header_.size - RC_HEADER_SIZE; }

    // Why Next() returned BROKEN.
    const std::string& Error() const { return error_; }

private:
    static const int CAPACITY = 2 * RC_MAX_PACKET;

    Uint8 buffer_[CAPACITY];
    int size_;      // bytes in buffer_
    int consumed_;  // of them, of the packet told last
    RcHeader header_;
    std::string error_;
};

#endif  // RemotePacket_h_DEFINED
