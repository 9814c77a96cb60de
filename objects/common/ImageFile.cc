#include "ImageFile.h"

#include "ByteOrder.h"

// Numbers in the header of an ELF file: the magic number at offset 0, the class (32 or 64 bits) at
// offset 4, the byte order at offset 5, and the machine at offset 18.
static const Uint32 ELF_MAGIC = 0x464c457f;
static const int ELF_LITTLE_ENDIAN = 1;
static const int ELF_32_BIT = 1;
static const int ELF_64_BIT = 2;
static const int ELF_MIPS = 8;
static const int ELF_X86_64 = 62;

ImageProcessor
ImageProcessorOf(const Uint8* bytes, int size)
{
    if (size < IMAGE_HEAD_SIZE) return imageUNKNOWN;
    // Treats every gzip file as an image of the robot, because the robot's images are gzip files
    // (1f 8b, method 8) and this code does not unpack them.  A packed image of the host must be
    // unpacked first.
    if (bytes[0] == 0x1f && bytes[1] == 0x8b && bytes[2] == 8) return imageMIPS;
    if (GetU32(bytes) != ELF_MAGIC || bytes[5] != ELF_LITTLE_ENDIAN) return imageUNKNOWN;
    const int machine = GetU16(bytes + 18);
    if (bytes[4] == ELF_32_BIT && machine == ELF_MIPS) return imageMIPS;
    if (bytes[4] == ELF_64_BIT && machine == ELF_X86_64) return imageX86_64;
    return imageUNKNOWN;
}

ImageProcessor
OwnProcessor()
{
    // Objects are built for two processors only, the robot's with 32 bits and x86-64 with 64 bits,
    // so the size of a pointer tells for which of them this code was compiled.
    return sizeof(void*) == 4 ? imageMIPS : imageX86_64;
}

const char*
ImageProcessorName(int processor)
{
    switch (processor) {
    case imageMIPS:
        return "the robot (MIPS)";
    case imageX86_64:
        return "openr-host (x86-64)";
    default:
        return "an unknown processor";
    }
}
