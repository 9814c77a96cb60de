// Messages to and from another process.
//
// Most of a message is bytes.  What is not: the RCRegions of notifications and readies, which
// travel as tokens with the memory's bytes beside them, and pointers of network messages into
// shared buffers, which travel as region and offset.
//
// For a region that came in, a stand-in is made here: an RCRegion of the same memory id.
// Readies give it back, and it goes the way it came.  Tokens are counted up and looked up, so that
// nothing from the network is ever taken for an address.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "distribution/wire.h"
#include "runtime/core/message.h"

class RCRegion;

namespace openr_host {

class System;

class Marshaller {
 public:
  // What the other side has: regions whose bytes need not be sent.  Null: none.
  using PeerHasMemory = std::function<bool(uint32_t region)>;

  // `makes_copies`: memory that comes in may be new to the region table.
  Marshaller(System* system, bool makes_copies) : system_(system), makes_copies_(makes_copies) {}
  Marshaller(const Marshaller&) = delete;
  Marshaller& operator=(const Marshaller&) = delete;

  // `out` points into `arena` and into the memory of regions.
  void Encode(const Message& message, const PeerHasMemory& peer_has, WireArena* arena,
              openr_wire_Message* out);

  // `message` has been taken by the other side: what a ready gave back is not here any more.
  void CompleteSend(const Message& message);

  // Fills `out`, which is fresh, but for class and due time.  "" or what is wrong with `in`, which
  // stays until ReleaseSample().
  std::string Decode(const openr_wire_Message& in, Message* out);
  void ReleaseSample();

  // Whether data of this region came in and have not been given back: it is the newer memory.
  bool HasImported(uint32_t region) const;

  // Whether this region went over there and may be there still.
  bool HasExported(uint32_t region) const;

  // Something that went over there and has not come back.
  struct ExportedRegion {
    RCRegion* region;
    size_t size;
    int32_t subject;  // who sent it: object and selector of the subject
    uint32_t subject_selector;
    int32_t observer;  // and to whom
    uint32_t observer_selector;
  };
  // All of it; it is not exported any more.
  std::vector<ExportedRegion> TakeExported();
  // The regions of what subjects of one object had sent.
  std::vector<RCRegion*> TakeExportedBy(ObjectId subject);

  // By tokens of the other side: what no ready will give back, since it was taken back here and
  // nobody has it any more.
  std::vector<uint64_t> TakeDroppedTokens();
  // The same, said by the other side.
  void PeerDropped(const std::vector<uint64_t>& tokens);

  // The other side is gone: what came from there is nobody's any more when it is given back.
  void PeerIsLost();

  // What came in comes back otherwise than by a ready.
  void ReleaseImported(RCRegion* region);

 private:
  void EncodeNotify(const Message& message, const PeerHasMemory& peer_has, WireArena* arena,
                    openr_wire_Notify* out);
  void EncodeReady(const Message& message, WireArena* arena, openr_wire_Ready* out);
  void EncodeAnt(const Message& message, WireArena* arena, openr_wire_Ant* out);
  std::string DecodeNotify(const openr_wire_Notify& in, Message* out);
  std::string DecodeReady(const openr_wire_Ready& in, Message* out);
  std::string DecodeAnt(const openr_wire_Ant& in, Message* out);
  std::string DecodePart(const openr_wire_NotifiedRegion& in, RCRegion** region);
  char* MemoryFor(const openr_wire_NotifiedRegion& in);
  void DropImported(RCRegion* region);

  System* const system_;
  const bool makes_copies_;
  struct ImportedRegion {
    uint64_t token;  // theirs; 0: they are gone
    // The bytes as they came, while they are there; then their hash.
    const uint8_t* bytes;
    uint64_t hash;
  };

  static bool IsChanged(const RCRegion& region, const ImportedRegion& imported);

  uint64_t last_token_ = 0;
  std::map<uint64_t, ExportedRegion> exported_;  // by our token
  // By TakeExportedBy(): the regions of tokens that may still be given back.
  std::map<uint64_t, uint32_t> withdrawn_;
  std::map<RCRegion*, ImportedRegion> imported_;  // looked up only, by stand-in
  std::map<uint64_t, uint32_t> dropped_;          // regions by token: see TakeDroppedTokens()
  std::vector<RCRegion*> sample_regions_;         // whose bytes are there still
};

}  // namespace openr_host
