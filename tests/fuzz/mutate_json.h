// Changes inputs of fuzz targets that are JSON, so that they stay JSON.
#pragma once

#include <string>
#include <string_view>

#include "tests/fuzz/mutate.h"

namespace openr_host {

// Returns whether `text` is JSON.
bool IsJson(std::string_view text);

// Makes one change to a value, or to an element of an object or an array: another number, a word of
// the dictionary, a copy, a removed element, another name.  Returns "" if `text` is no JSON.
std::string MutateJson(std::string_view text, const FuzzWords& words, FuzzRandom* random);

}  // namespace openr_host
