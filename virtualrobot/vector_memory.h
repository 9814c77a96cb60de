// What all vectors have in common, whoever made them: a header in shared memory whose
// numbers an object may have spoilt, and regions that are used again when they are free.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <string>
#include <vector>

namespace openr_host {

class System;

// A vector that an object sent, seen no further than its region reaches.
struct SentVector {
  RCRegion* region = nullptr;
  size_t bytes = 0;                   // that may be looked at
  ODataVectorInfo* header = nullptr;  // null: they are too few for one
  int elements = 0;                   // numData, as far as there is memory for their infos

  // Address of `size` bytes at `offset` of the vector; null when they are not all inside.
  char* At(size_t offset, size_t size) const;
};

// Describes in `problems` what is wrong with the vector as a whole; `kind` is "command
// vector" or "sound vector".  `info_size` is that of one element's info.
SentVector ReadSentVector(RCRegion* region, size_t info_size, const char* kind, System& system,
                          std::vector<std::string>* problems);

// Whether the header names the memory it came in.  The robot finds the vector by that id
// and answers a wrong one with oINVALID_DATA_VECTOR_ID.  A vector in memory that the robot
// itself made counts as good: TCPGateway puts there what a program elsewhere sent, whose id
// is one of that program's machine.
bool NamesItsMemory(const SentVector& vector, System& system);

// The key of a vector that waits; ovrsynckeyUNDEF when it is too small to have one.
OVRSyncKey SyncKeyOf(const RCRegion& region);

// Frames by which a vector is to be delayed; more than 10 s is pointed out.
int64_t WaitOf(const SentVector& vector, std::vector<std::string>* problems);

// Regions that the robot fills for objects, of one stream.  One to which somebody refers is
// never filled again.
class VectorPool {
 public:
  // Null when all are in use: make one and Add() it.
  RCRegion* Free() const;

  // Objects that keep many are a finding.  Runs as code of an object.
  void Add(RCRegion* region);

 private:
  static constexpr size_t kMany = 64;  // chosen; 2 s of sensors

  std::vector<RCRegion*> regions_;
};

// A new region for a vector with `elements` infos and `data_bytes` behind them; the
// header is filled in, one reference belongs to the caller.
RCRegion* NewVectorRegion(ODataType type, size_t info_size, size_t elements, size_t data_bytes);

}  // namespace openr_host
