// Memory of vectors: safe reading of vectors that objects sent, and regions for vectors that the
// robot sends.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <string>
#include <vector>

namespace openr_host {

class System;

// A vector that an object sent.  The object may have written wrong numbers into its header, so
// nothing behind the end of the region is read.
struct SentVector {
  RCRegion* region = nullptr;
  size_t bytes = 0;                   // bytes that may be read
  ODataVectorInfo* header = nullptr;  // null: the bytes are too few for a header
  int elements = 0;                   // numData, but no more than have memory for their infos

  // Address of `size` bytes at `offset` of the vector; null when some of them lie outside.
  char* At(size_t offset, size_t size) const;
};

// Reads the header of the vector in `region`.  Adds a text to `problems` for each thing that is
// wrong with it.  `kind` is "command vector" or "sound vector"; `info_size` is the size of the info
// of one element.
SentVector ReadSentVector(RCRegion* region, size_t info_size, const char* kind, System& system,
                          std::vector<std::string>* problems);

// Whether the header has the id of the memory in which the vector came.  The robot finds the vector
// by that id and answers a wrong id with oINVALID_DATA_VECTOR_ID.  A vector in memory of a system
// object counts as good with any id: TCPGateway copies vectors of programs on other machines there,
// and their headers have ids of those machines.
bool NamesItsMemory(const SentVector& vector, System& system);

// The synchronisation key of a vector; ovrsynckeyUNDEF when the region is too small for a header.
OVRSyncKey SyncKeyOf(const RCRegion& region);

// Frames by which the vector asks to be delayed.  More than 10 s is a problem.
int64_t WaitOf(const SentVector& vector, std::vector<std::string>* problems);

// Regions that the robot fills for one stream of vectors and uses again when they are free.  A
// region is free when no object refers to it.
class VectorPool {
 public:
  // A free region.  Null when all are in use; then the caller makes one and calls Add().
  RCRegion* Free() const;

  // Takes over `region` with one reference.  Adds a finding when objects keep very many regions.
  // Runs as code of an object.
  void Add(RCRegion* region);

 private:
  static constexpr size_t kMany = 64;  // chosen; 2 s of sensors

  std::vector<RCRegion*> regions_;
};

// Makes a region for a vector with `elements` infos and `data_bytes` behind them, and fills in the
// header.  The one reference to it belongs to the caller.
RCRegion* NewVectorRegion(ODataType type, size_t info_size, size_t elements, size_t data_bytes);

}  // namespace openr_host
