// Names places in the source code of objects for the texts of findings: "Talker.cc:57".
//
// A name comes from the debug information of an image, which the runtime cannot read.  So
// openr/ending/crash_log.cc gives the runtime a function that can read it (SetPlaceNamer()).
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// A function that returns the name of the place in the source ("Talker.cc:57") of the instruction
// at `address`, or "" if this name is not known.
using PlaceNamer = std::string (*)(const void* address);

// Sets the function that NameOfPlace() calls to find the name of a place in the source.  With null,
// which is the initial value, no place has a name.
void SetPlaceNamer(PlaceNamer namer);

// Returns the name of the place in the source of the instruction at `address` ("Talker.cc:57"), or
// "" if this name is not known.
std::string NameOfPlace(const void* address);

// Searches the stack for the innermost call made by code of the current object's image, and returns
// the address of the call.  Returns null if no code of that image is on the stack.
const void* CallerInImage();

// Returns the calls on the stack that were made by code of the current object's image, the
// innermost first, at most kCallsMax.  Returns an empty list if the image is not at its planned
// address, because code of the image is recognized by this address.
std::vector<const void*> CallsInImage();
constexpr size_t kCallsMax = 8;

// Returns the place ("Talker.cc:57") of the first of `calls` that is in a source of the object and
// not in a header.  Memory is mostly allocated by inline functions of headers such as <vector>,
// which tell users little.  If all calls are in headers, returns the first known place.  Returns ""
// if the place of no call is known.
std::string NameOfCalls(const std::vector<const void*>& calls);

// Returns the name of the entry whose handler runs in the current object, with a colon and a blank,
// such as "DoStart: ".  Returns "" if no handler runs.
std::string InHandler();

// Returns the end of a finding's text, such as ", at Talker.cc:57", with the place in the source
// where the object has called the runtime (CallerInImage()).  Returns "" if that place has no name.
std::string AtCaller();

}  // namespace openr_host
