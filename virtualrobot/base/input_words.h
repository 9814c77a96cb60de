// Reads the words of inputs (runtime/core/inputs.h): numbers, percentages and durations.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// ReadNumber() reads `text` as a number.  ReadPercent() reads `text` as a percentage, such as
// "30%", from 0% to 100%.  Both return "" or the error.
std::string ReadNumber(std::string_view text, double* number);
std::string ReadPercent(std::string_view text, int* percent);

// Reads the duration of an input with the words `words`.  If they end in "for DURATION", removes
// these two words and sets `frames` to the duration in frames, rounded up, at least one.  Otherwise
// changes nothing.  Returns "" or the error.
std::string TakeForDuration(std::vector<std::string>* words, std::optional<int64_t>* frames);

}  // namespace openr_host
