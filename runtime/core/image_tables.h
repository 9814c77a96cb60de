// Checks the tables in the file of an image before the dynamic linker uses them.
//
// The dynamic linker trusts these tables.  A damaged table makes it write to wrong addresses, which
// ends the process without a message.
#pragma once

#include <string>

namespace openr_host {

// Returns "" if the tables that the dynamic linker reads in `bytes`, the content of a shared object
// for this processor, are sound: everything that they name lies in the memory of the object.
// Otherwise returns the name of the first damaged table, such as "the table of relocations".
// REQUIRES: the bytes of all segments are in `bytes`.
//
// Does not find damage in code and in data, in the versions that the object defines, and in the
// values of its symbols.
std::string DamagedTableIn(const std::string& bytes);

}  // namespace openr_host
