// Functions for the memory of vectors (messages with commands, sound, images or sensor values).
// They read safely from vectors that objects sent, and make regions for vectors that the robot
// sends.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <string>
#include <vector>

namespace openr_host {

class System;

// A vector that an object sent.  Because the object may have written wrong numbers into the header,
// every access is checked against the end of the region.
struct SentVector {
  RCRegion* region = nullptr;
  size_t bytes = 0;                   // number of bytes of the vector that may be read
  ODataVectorInfo* header = nullptr;  // null: the region is too small for a header
  // Number of elements: header->numData, or fewer when the region has no room for the info structs
  // (such as OCommandInfo) of so many elements.
  int elements = 0;

  // Returns the address of `size` bytes at `offset` in the vector; null when some of the bytes lie
  // outside the region.
  char* At(size_t offset, size_t size) const;
};

// Reads the header of the vector in `region`.  Adds to `problems` a text for each mistake in the
// header.  `kind` is "command vector" or "sound vector"; `info_size` is the size of the info struct
// of one element, such as OCommandInfo.
SentVector ReadSentVector(RCRegion* region, size_t info_size, const char* kind, System& system,
                          std::vector<std::string>* problems);

// Returns whether the header of the vector has the id of the memory in which the vector came.  The
// robot finds a vector by this id, and answers a wrong id with oINVALID_DATA_VECTOR_ID.  Also
// returns true for a wrong id if a system object made the memory.  The reason is the system object
// TCPGateway: it copies vectors of other machines into its own memory, but their headers still have
// the ids of those machines.
bool NamesItsMemory(const SentVector& vector, System& system);

// Returns the synchronisation key of the vector in `region`; ovrsynckeyUNDEF when the region is too
// small for a header.
OVRSyncKey SyncKeyOf(const RCRegion& region);

// Returns the number of frames (8 ms) by which the vector asks to be delayed.  Adds a text to
// `problems` when the delay is more than 10 s.
int64_t WaitOf(const SentVector& vector, std::vector<std::string>* problems);

// The regions that the robot fills for its vectors of one kind (sensor values, images or sound).  A
// region is used again when it is free, that is, when no object refers to it.
class VectorPool {
 public:
  // Returns a region of the pool that is free.  Returns null when all regions of the pool are in
  // use; then the caller makes a new region and calls Add().
  RCRegion* FindFree() const;

  // Adds `region` to the pool.  The caller must hold the only reference to the region; the pool
  // takes this reference over.  Adds a finding when objects keep very many regions.  REQUIRES: a
  // handler of an object runs, because the references to a region are counted separately for each
  // object.
  void Add(RCRegion* region);

  // Gives up the references to all regions of the pool.  REQUIRES: the object that has called Add()
  // is the current object.
  void Clear();

 private:
  // Number of regions in the pool at which Add() reports a finding, because objects then probably
  // never give regions back.  The number is our choice: 64 regions hold the sensor vectors of 2 s.
  static constexpr size_t kMany = 64;

  std::vector<RCRegion*> regions_;
};

// Makes a region for a vector: a header, an info struct of `info_size` bytes for each of `elements`
// elements, and `data_bytes` bytes of data.  Fills in the header.  The caller owns the only
// reference to the region.
RCRegion* NewVectorRegion(ODataType type, size_t info_size, size_t elements, size_t data_bytes);

}  // namespace openr_host
