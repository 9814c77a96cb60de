#include "virtualrobot/sound/sound_library.h"

#include "runtime/base/lazy_library.h"

namespace openr_host {
namespace {

SndfileFunctions LoadSndfile() {
  const LazyLibrary library(
      "libsndfile.so.1", "libsndfile, by which sound files are read and written,", "libsndfile1");
  SndfileFunctions functions;
#define OPENR_SNDFILE_FIND(name) library.Find(&functions.name, #name);
  OPENR_SNDFILE_FUNCTIONS(OPENR_SNDFILE_FIND)
#undef OPENR_SNDFILE_FIND
  return functions;
}

}  // namespace

const SndfileFunctions& Sndfile() {
  static const SndfileFunctions functions = LoadSndfile();
  return functions;
}

}  // namespace openr_host
