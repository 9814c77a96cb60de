// Reads image files from a Memory Stick.  An image has the code of one object of the robot.  On the
// host an image is a shared object for this machine, and may be compressed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

struct ImageFile {
  std::string bytes;  // bytes of the shared object, decompressed
  // True if the image file is compressed with gzip.  The Makefiles of some programs compress the
  // images.
  bool is_compressed = false;
  bool is_for_robot = false;  // whether the file is a MIPS binary
  std::string problem;        // the reason why the file cannot be loaded; "" if it can be loaded
};

// Reads the file `path` and checks everything that can be checked without loading the file: whether
// it is an image, is for this machine, and is complete.
ImageFile ReadImageFile(const std::string& path);

// Does the checks of ReadImageFile() for `bytes`, the content of a file that the caller has already
// read: whether it is an image, is for this machine, and is complete.
ImageFile CheckImage(std::string bytes);

// Returns the .ocf text (name, priority and memory sizes of the object) in the bytes of a host
// image; "" if the image has no such text.
std::string OcfTextOf(const std::string& bytes);

// Returns the name of the library of AddressSanitizer that a host image needs, such as
// "libasan.so.8"; "" if the image was not built with openr build --sanitize.
std::string SanitizerOf(const std::string& bytes);

// Returns the names of all functions that an image defines, mangled as in its table of symbols;
// none if the image was stripped.
std::vector<std::string> FunctionsIn(const std::string& bytes);

// Returns all sequences of at least 8 printable characters in the bytes of an image, as the tool
// `strings` does.
std::vector<std::string_view> TextsIn(std::string_view bytes);

// Returns the services of the object in an image without loading the image: all texts in its bytes
// that have the form of service names, such as "JointMover.Move.MoveCommand.O".
std::vector<std::string> ServicesInImage(std::string_view bytes);

}  // namespace openr_host
