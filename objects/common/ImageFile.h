//
// The processor that an image (.BIN) is for, as its first bytes tell.
//
// An image of the robot is a gzip file with an ELF file of 32 bits for MIPS inside
// (docs/openr/binary.md); an image of the host is an ELF file of 64 bits for x86-64.
//

#ifndef ImageFile_h_DEFINED
#define ImageFile_h_DEFINED

#include "FixedTypes.h"

// The numbers are part of the remote control (INFO).
enum ImageProcessor { imageUNKNOWN = 0, imageMIPS = 1, imageX86_64 = 2 };

// Number of bytes at the beginning of an image that tell its processor.
const int IMAGE_HEAD_SIZE = 20;

// Returns the processor of an image that begins with `bytes`, or imageUNKNOWN when the bytes do not
// begin an image.
ImageProcessor ImageProcessorOf(const Uint8* bytes, int size);

// Returns the processor for which this code was compiled, which runs only images of its own kind.
ImageProcessor OwnProcessor();

// Returns words for messages: "the robot (MIPS)".
const char* ImageProcessorName(int processor);

#endif  // ImageFile_h_DEFINED
