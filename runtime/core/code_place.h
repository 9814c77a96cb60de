// Names of places in the code of objects, for findings: "Talker.cc:57".
//
// The name of a place comes from the debug information of an image.  This library does not read
// debug information, so the program gives it a function that does (openr/).
#pragma once

#include <string>

namespace openr_host {

// A function that returns the place of the instruction at `address`; "" if it is not known.
using PlaceNamer = std::string (*)(const void* address);

// Sets the function that names places; null, as at the start: places have no names.
void SetPlaceNamer(PlaceNamer namer);

// Returns the place of the instruction at `address` ("Talker.cc:57"); "" if it is not known.
std::string NameOfPlace(const void* address);

// Searches the stack for the innermost call that was made by code of the current object's image,
// and returns the address of the call; null if no code of that image is on the stack.
const void* CallerInImage();

// Returns ", at Talker.cc:57" for CallerInImage(); "" if its place is not known.
std::string AtCaller();

}  // namespace openr_host
