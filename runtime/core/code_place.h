// Names of places in the code of objects, for findings: "Talker.cc:57".
//
// Looking a place up needs the debug information of images, which the program reads and this
// library does not; so the program lends it a function.
#pragma once

#include <string>

namespace openr_host {

// Called with the address of an instruction; "" when nothing is known about it.
using PlaceNamer = std::string (*)(const void* address);

// Null: no places are named, as at the start.
void SetPlaceNamer(PlaceNamer namer);

// "Talker.cc:57", or "" when nobody knows.
std::string NameOfPlace(const void* address);

// The instruction of the current object's image that has called the runtime, whatever lies
// between; null when its code is not running.
const void* CallerInImage();

// ", at Talker.cc:57" of that, or "".
std::string AtCaller();

}  // namespace openr_host
