// Converts messages to samples of openr_wire.idl and back.
//
// Most payloads are plain bytes.  Two kinds contain pointers.  Notifications and ready messages
// refer to RCRegions, which are sent as a token and the bytes of the memory.  Messages of the
// network stack point into shared buffers; the pointer is sent as region id and offset.
//
// Each process has a Marshaller for its peer.  A region that it sends is exported until a ready
// message of the peer gives it back.  For a region that it receives (imported), it creates an
// RCRegion with the same memory id; the region stays imported until a ready message of this process
// gives it back.  Tokens are numbers that are looked up in a table, so data from the network are
// never used as an address.
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
  // Returns whether the peer has the region in memory; the bytes of such a region are not sent.  A
  // null function means that the peer has none.
  using PeerHasMemory = std::function<bool(uint32_t region)>;

  // `makes_copies` is true in workers: a received region may be new to their region table, so the
  // table gets a copy of its memory.  It is false in the master, which assigns region ids and so
  // knows every region.
  Marshaller(System* system, bool makes_copies) : system_(system), makes_copies_(makes_copies) {}
  Marshaller(const Marshaller&) = delete;
  Marshaller& operator=(const Marshaller&) = delete;

  // Encodes `message`.  `out` points into `arena` and into the memory of regions.
  void Encode(const Message& message, const PeerHasMemory& peer_has, WireArena* arena,
              openr_wire_Message* out);

  // To be called when the peer has accepted `message`.  If it is a ready message, releases the
  // received regions that it gives back.
  void CompleteSend(const Message& message);

  // Decodes `in` into the new message `out`, except for its class and due time, which the caller
  // sets.  Returns "" or what is wrong with `in`.  `in` must stay valid until ReleaseSample().
  std::string Decode(const openr_wire_Message& in, Message* out);
  void ReleaseSample();

  // Returns whether data of `region` were received from the peer and not given back.  If so, the
  // copy of the region in this process is newer than the memory in the peer.
  bool HasImported(uint32_t region) const;

  // Returns whether `region` was sent to the peer, which may still use it.
  bool HasExported(uint32_t region) const;

  // A region that was sent to the peer and has not been given back.
  struct ExportedRegion {
    RCRegion* region;
    size_t size;
    int32_t subject;  // object and selector of the sending subject
    uint32_t subject_selector;
    int32_t observer;  // object and selector of the receiving observer
    uint32_t observer_selector;
  };
  // Returns all regions that were sent to the peer and not given back, and forgets them.
  std::vector<ExportedRegion> TakeExported();
  // Returns the regions that the subjects of object `subject` have sent and that were not given
  // back, and forgets them.  To be called when this object was replaced.  The peer may still use
  // the regions.
  std::vector<RCRegion*> TakeExportedBy(ObjectId subject);

  // Returns the tokens of received regions that no ready message will give back, so that the peer
  // can forget these tokens.  The regions were released here without such a message, and their
  // memory is not used any more.
  std::vector<uint64_t> TakeDroppedTokens();
  // Forgets regions that the peer will not give back.  `tokens` is the result of
  // TakeDroppedTokens() in the peer.
  void PeerDropped(const std::vector<uint64_t>& tokens);

  // Handles the loss of the peer.  Regions received from it have no sender any more, so ready
  // messages do not give them back.
  void PeerIsLost();

  // Releases a region that was received from the peer, without giving it back in a ready message.
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
    uint64_t token;  // the peer's token for the region; 0: the peer is lost
    // The received bytes, with which IsChanged() compares the region: `bytes` while the sample is
    // valid, afterwards only their hash.
    const uint8_t* bytes;
    uint64_t hash;
  };

  // Returns whether the observer has written into the region since the region was received.
  static bool IsChanged(const RCRegion& region, const ImportedRegion& imported);

  uint64_t last_token_ = 0;
  std::map<uint64_t, ExportedRegion> exported_;  // by the token that this process gave
  // Regions that TakeExportedBy() has forgotten but that the peer may still give back, by token.
  std::map<uint64_t, uint32_t> withdrawn_;
  // Imported regions, by their RCRegion.  The map is never iterated where the order matters,
  // because the order of pointers differs from run to run.
  std::map<RCRegion*, ImportedRegion> imported_;
  std::map<uint64_t, uint32_t> dropped_;   // by token; see TakeDroppedTokens()
  std::vector<RCRegion*> sample_regions_;  // received regions whose ImportedRegion::bytes is set
};

}  // namespace openr_host
