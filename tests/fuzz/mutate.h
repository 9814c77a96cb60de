// Changes inputs of the fuzz targets with knowledge of their form.  libFuzzer itself changes single
// bytes, which hardly ever makes a valid file of names, numbers and lines.
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

using FuzzRandom = std::minstd_rand;
using FuzzWords = std::vector<std::string>;

// Returns whether `bytes` have no control characters but those between words and lines.
bool IsText(std::string_view bytes);

// Makes one change to `text`: renames a word (letters, digits, '_') in one or all of its places,
// puts another word, number or symbol in its place, multiplies the numbers of a column, or copies,
// removes or moves a line.  `words` is the dictionary of the target.  Returns `text` itself if it
// has no words.
std::string MutateText(std::string_view text, const FuzzWords& words, FuzzRandom* random);

// Changes one of the texts in `bytes`, as MutateText() does.  A text is a row of at least 8
// characters without control characters, such as a section of an image.  Bytes behind the text stay
// in their places: a text that becomes shorter ends with NULs, and a longer text covers the bytes
// behind it.  Returns `bytes` themselves if they have no text.
std::string MutateTextIn(std::string bytes, const FuzzWords& words, FuzzRandom* random);

// Changes a number of 1, 2 or 4 bytes, little-endian: to a near one, a small one, or a limit of a
// type.  Returns `bytes` themselves if there are too few.
std::string MutateNumber(std::string bytes, FuzzRandom* random);

// Puts `second` behind `first`, or lines of it between the lines of `first`.
std::string JoinTexts(std::string_view first, std::string_view second, FuzzRandom* random);

// Sets the checksums of all whole blocks of a recording (docs/trace-format.md) to the right value.
// Other bytes stay as they are.
void FixRecording(std::string* bytes);

// Returns the content of a gzip file; "" if `bytes` is none.  Compress() is the inverse.
std::string Decompress(std::string_view bytes);
std::string Compress(std::string_view bytes);

}  // namespace openr_host
