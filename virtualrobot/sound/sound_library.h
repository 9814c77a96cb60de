// Sndfile(): the functions of libsndfile that this program calls.
//
// The library is loaded by the first call of Sndfile() and not with the program, because it brings
// seven codecs along, and most runs neither read nor write a sound file.
#pragma once

#include <sndfile.h>

namespace openr_host {

// Calls F(name) for each function of libsndfile that this program uses.
// clang-format off
#define OPENR_SNDFILE_FUNCTIONS(F)                                                       \
  F(sf_close) F(sf_command) F(sf_error) F(sf_error_number) F(sf_open) F(sf_readf_short)  \
  F(sf_seek) F(sf_strerror) F(sf_write_short)
// clang-format on

// Pointers to the functions of libsndfile; each member has the name of its function.
struct SndfileFunctions {
#define OPENR_SNDFILE_POINTER(name) decltype(&::name) name;
  OPENR_SNDFILE_FUNCTIONS(OPENR_SNDFILE_POINTER)
#undef OPENR_SNDFILE_POINTER
};

// Returns the functions of libsndfile; the first call loads the library.  Throws std::runtime_error
// if the library cannot be loaded.
const SndfileFunctions& Sndfile();

}  // namespace openr_host
