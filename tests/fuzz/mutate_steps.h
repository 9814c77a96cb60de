// Changes inputs of fuzz targets that are programs: rows of steps, each a few bytes long.  A change
// of single bytes moves all steps behind it, so that little of the program is left.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/fuzz/mutate.h"

namespace openr_host {

// The places at which the steps of a program begin, in rising order.
using FuzzStarts = std::vector<size_t>;

// Makes one change to a program: copies, removes or moves a row of steps, or changes one byte of a
// step.  Returns `program` itself if it has no steps.
std::string MutateSteps(const std::string& program, const FuzzStarts& starts, FuzzRandom* random);

// Puts a row of steps of `second` between the steps of `first`.
std::string JoinSteps(const std::string& first, const FuzzStarts& first_starts,
                      const std::string& second, const FuzzStarts& second_starts,
                      FuzzRandom* random);

// Makes one change to the messages of the target panel_websocket, which come in parts: a byte with
// flags, the size in two bytes, and the text.  Changes a text, divides a part in two, or joins two
// parts; the sizes are right afterwards.
std::string MutateParts(const std::string& input, const FuzzWords& words, FuzzRandom* random);

}  // namespace openr_host
