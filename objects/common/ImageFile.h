//
// Finds the processor for which an image (.BIN) was made, by its first bytes.
//
// An image of the robot is a gzip file that contains an ELF file of 32 bits for MIPS
// (docs/openr/binary.md); an image of the host is an ELF file of 64 bits for x86-64.
//

#ifndef ImageFile_h_DEFINED
#define ImageFile_h_DEFINED

#include "FixedTypes.h"

// Kinds of CPU for which the code of an image can be compiled.  The numbers are part of the remote
// control's protocol (INFO).
enum ImageProcessor { imageUNKNOWN = 0, imageMIPS = 1, imageX86_64 = 2 };

// Number of bytes at the beginning of an image that are needed to find its processor.
const int IMAGE_HEAD_SIZE = 20;

// Returns the processor of an image that begins with `bytes`, or imageUNKNOWN when the bytes do not
// begin an image.
ImageProcessor ImageProcessorOf(const Uint8* bytes, int size);

// Returns the processor for which this code was compiled.  An image can be run only if it was made
// for this processor.
ImageProcessor OwnProcessor();

// Returns the name of a processor for messages to people, such as "the robot (MIPS)".
const char* ImageProcessorName(int processor);

#endif  // ImageFile_h_DEFINED
