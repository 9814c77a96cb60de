#include "RemotePacket.h"

#include <string.h>

#include "ByteOrder.h"
#include "TextFormat.h"

void
RcHeader::Read(const Uint8* packet)
{
    size = GetU16(packet + 2);
    version = packet[4];
    command = packet[5];
    tag = GetU16(packet + 6);
}

// ---- RcWriter ------------------------------------------------------------------------

RcWriter::RcWriter(Uint8* buffer, int capacity)
    : buffer_(buffer), capacity_(capacity), size_(0), hasOverflowed_(false)
{
}

bool
RcWriter::HasRoom(int count)
{
    // Refuses all later fields, too, because a smaller field that still fits would be read in place
    // of the missing field.
    if (capacity_ - size_ < count) hasOverflowed_ = true;
    return !hasOverflowed_;
}

void
RcWriter::U8(Uint32 value)
{
    if (HasRoom(1)) buffer_[size_++] = (Uint8)value;
}

void
RcWriter::U16(Uint32 value)
{
    if (!HasRoom(2)) return;
    PutU16(buffer_ + size_, (Uint16)value);
    size_ += 2;
}

void
RcWriter::U32(Uint32 value)
{
    if (!HasRoom(4)) return;
    PutU32(buffer_ + size_, value);
    size_ += 4;
}

// Returns `c`, or '?' when `c` is not printable ASCII, because strings come from files and from the
// network and are shown on terminals.
static char
Ascii(char c)
{
    return c >= ' ' && c <= '~' ? c : '?';
}

void
RcWriter::String(const std::string& text)
{
    const int length = text.size() < 255 ? (int)text.size() : 255;
    if (!HasRoom(1 + length)) return;
    buffer_[size_++] = (Uint8)length;
    for (int i = 0; i < length; i++) buffer_[size_++] = (Uint8)Ascii(text[i]);
}

void
RcWriter::Bytes(const Uint8* bytes, int size)
{
    if (size <= 0 || !HasRoom(size)) return;
    memcpy(buffer_ + size_, bytes, (size_t)size);
    size_ += size;
}

void
RcWriter::Truncate(int size)
{
    if (size < size_) size_ = size;
    hasOverflowed_ = false;
}

void
RcWriter::PutHeader(int command, int tag, int version)
{
    if (size_ < RC_HEADER_SIZE) return;
    PutU16(buffer_, RC_MAGIC);
    PutU16(buffer_ + 2, (Uint16)size_);
    buffer_[4] = (Uint8)version;
    buffer_[5] = (Uint8)command;
    PutU16(buffer_ + 6, (Uint16)tag);
}

// ---- RcReader ------------------------------------------------------------------------

bool
RcReader::Has(int count)
{
    // Lets all later reads fail, too, because bytes behind a missing field would be read as another
    // field.
    if (size_ - at_ < count) hasFailed_ = true;
    return !hasFailed_;
}

Uint8
RcReader::U8()
{
    return Has(1) ? bytes_[at_++] : 0;
}

Uint16
RcReader::U16()
{
    if (!Has(2)) return 0;
    at_ += 2;
    return GetU16(bytes_ + at_ - 2);
}

Uint32
RcReader::U32()
{
    if (!Has(4)) return 0;
    at_ += 4;
    return GetU32(bytes_ + at_ - 4);
}

Sint32
RcReader::S32()
{
    if (!Has(4)) return 0;
    at_ += 4;
    return GetS32(bytes_ + at_ - 4);
}

std::string
RcReader::String()
{
    const int length = U8();
    if (!Has(length)) return std::string();
    at_ += length;
    std::string text((const char*)bytes_ + at_ - length, length);
    for (int i = 0; i < length; i++) text[i] = Ascii(text[i]);
    return text;
}

// ---- RcFramer ------------------------------------------------------------------------

void
RcFramer::Reset()
{
    memset(buffer_, 0, sizeof(buffer_));
    memset(&header_, 0, sizeof(header_));
    size_ = 0;
    consumed_ = 0;
    error_ = "";
}

void
RcFramer::Append(const Uint8* bytes, int size)
{
    if (size <= 0 || size > Room()) return;
    memcpy(buffer_ + size_, bytes, size);
    size_ += size;
}

RcFramer::Result
RcFramer::Next()
{
    size_ -= consumed_;
    memmove(buffer_, buffer_ + consumed_, size_);
    consumed_ = 0;
    // Checks the magic number as soon as its two bytes have arrived.  So a client of another
    // protocol gets an answer even if it sends fewer bytes than a header has.
    if (size_ >= 2 && GetU16(buffer_) != RC_MAGIC) {
        error_ = TextFormat("a packet begins with 'RC', not with the bytes %02x %02x", buffer_[0],
                            buffer_[1]);
        return BROKEN;
    }
    if (size_ < RC_HEADER_SIZE) return NEEDS_MORE;
    header_.Read(buffer_);
    if (header_.size < RC_HEADER_SIZE || header_.size > RC_MAX_PACKET) {
        error_ = TextFormat("size of a packet is %d, must be %d to %d", header_.size,
                            RC_HEADER_SIZE, RC_MAX_PACKET);
        return BROKEN;
    }
    if (size_ < header_.size) return NEEDS_MORE;
    consumed_ = header_.size;
    return PACKET;
}
