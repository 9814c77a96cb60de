#include "distribution/dds.h"

#include "runtime/base/lazy_library.h"

namespace openr_host {
namespace {

DdsFunctions Load() {
  // Makes the symbols of the library global (the argument `true`), because the security plugins of
  // Cyclone DDS may need them.
  const LazyLibrary library(OPENR_DDS_LIBRARY, "Cyclone DDS, by which processes exchange data,",
                            "libddsc0debian", true);
  DdsFunctions functions;
#define OPENR_DDS_FIND(name) library.Find(&functions.name, #name);
  OPENR_DDS_FUNCTIONS(OPENR_DDS_FIND)
#undef OPENR_DDS_FIND
  return functions;
}

}  // namespace

const DdsFunctions& Dds() {
  static const DdsFunctions functions = Load();
  return functions;
}

}  // namespace openr_host
