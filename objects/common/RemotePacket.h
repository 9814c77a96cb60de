//
// Packets of the remote control: the byte level of docs/remote-control.md.
//
// RCServer on the robot and the client on the host use this code.  No function reads or writes
// beyond its buffer: reading after the end of a packet returns zeros and sets a flag.
//

#ifndef RemotePacket_h_DEFINED
#define RemotePacket_h_DEFINED

#include <string>

#include "FixedTypes.h"

const int RC_PORT = 54000;
const Uint16 RC_MAGIC = 0x4352;  // the bytes 'R', 'C'

// Versions of the protocol.  Version 2 adds commands, such as the commands for files.  A client
// uses version 1 for all other commands, so that it can talk to older robots.
const int RC_VERSION = 1;
const int RC_VERSION_FILES = 2;

const int RC_HEADER_SIZE = 8;          // size of the header of a request, in bytes
const int RC_ANSWER_HEADER_SIZE = 16;  // size of the header of an answer, in bytes

// Largest size of a whole packet, in bytes.  The robot sends at most 1024 bytes at once; the rest
// of a larger packet would wait up to 200 ms (BBS 1530, 1592).
const int RC_MAX_PACKET = 1024;

// The header with which requests and answers begin, without the magic number.
struct RcHeader {
    Uint16 size;  // size of the whole packet in bytes
    Uint8 version;
    Uint8 command;
    Uint16 tag;

    // Reads the header from the first RC_HEADER_SIZE bytes of `packet`.  Does not check the values.
    void Read(const Uint8* packet);
};

// Writes numbers and strings, one after the other, into a buffer of the caller.
class RcWriter {
public:
    RcWriter(Uint8* buffer, int capacity);

    void U8(Uint32 value);
    void U16(Uint32 value);
    void U32(Uint32 value);
    void S32(Sint32 value) { U32((Uint32)value); }

    // Writes a length byte and the characters.  Cuts off a string that is longer than 255
    // characters.  Writes '?' for every character that is not printable ASCII.
    void String(const std::string& text);

    int Size() const { return size_; }
    bool HasOverflowed() const { return hasOverflowed_; }

    // Returns the place in the buffer at which the next byte will be written.
    Uint8* End() const { return buffer_ + size_; }
    // Returns the number of bytes of the buffer that are free, from End() on.
    int Room() const { return capacity_ - size_; }

    // Counts `count` bytes that the caller has written at End().  REQUIRES: count <= Room().
    void Add(int count) { size_ += count; }

    // Drops all bytes in the buffer after the first `size` bytes.
    void Truncate(int size);

    // Writes the header of the packet into the first RC_HEADER_SIZE bytes.  Called last, when the
    // size of the packet is known.
    void PutHeader(int command, int tag, int version = RC_VERSION);

    // Writes the `size` bytes at `bytes` to the buffer without a change.
    void Bytes(const Uint8* bytes, int size);

private:
    bool HasRoom(int count);

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
    std::string String();  // the result has '?' for every character that is not printable ASCII

    // Skips the next `count` bytes of the packet.
    void Skip(int count)
    {
        if (Has(count)) at_ += count;
    }

    // Returns the bytes of the packet that were not read yet.
    const Uint8* Rest() const { return bytes_ + at_; }
    // Returns the number of bytes of the packet that were not read yet.
    int RestSize() const { return size_ - at_; }

    // Returns whether all reads found their bytes in the packet, and no byte of the packet is left
    // over.
    bool IsComplete() const { return !hasFailed_ && at_ == size_; }
    bool HasFailed() const { return hasFailed_; }

private:
    bool Has(int count);

    const Uint8* bytes_;
    int size_;
    int at_;
    bool hasFailed_;
};

// Splits a stream of bytes into packets.  A packet may come in several pieces, and several packets
// may come at once.
class RcFramer {
public:
    enum Result {
        NEEDS_MORE,  // the next packet is not complete yet
        PACKET,
        BROKEN  // the bytes are no packet, so no later packet can be found either
    };

    RcFramer() { Reset(); }
    void Reset();

    // Returns the number of bytes for which Append() has room; at least RC_MAX_PACKET after Next()
    // has returned NEEDS_MORE.
    int Room() const { return CAPACITY - size_; }

    // Appends `size` bytes to the stream.  REQUIRES: size <= Room().
    void Append(const Uint8* bytes, int size);

    // Finds the next packet.  When the result is PACKET, Header() and Payload() return its parts
    // until the next call of Next() or Append().
    Result Next();
    const RcHeader& Header() const { return header_; }
    const Uint8* Payload() const { return buffer_ + RC_HEADER_SIZE; }
    int PayloadSize() const { return header_.size - RC_HEADER_SIZE; }

    // Returns the reason why the bytes are no packet, after Next() has returned BROKEN.
    const std::string& Error() const { return error_; }

private:
    static const int CAPACITY = 2 * RC_MAX_PACKET;

    Uint8 buffer_[CAPACITY];
    int size_;      // number of bytes in buffer_
    int consumed_;  // size of the packet that Next() found last, in bytes
    RcHeader header_;
    std::string error_;
};

#endif  // RemotePacket_h_DEFINED
