// Converts messages to samples of openr_wire.idl and back.
//
// Most payloads are plain bytes.  Two kinds contain pointers.  Notifications and ready messages
// refer to RCRegions, which are sent as a token and the bytes of the memory.  Messages of the
// network stack point into shared buffers; the pointer is sent as region id and offset.
//
// A Marshaller exchanges messages with one other process, its peer.  A region that it sends is
// exported until a ready message of the peer gives it back.  For a region that it receives
// (imported), it creates an RCRegion with the same memory id; the region stays imported until a
// ready message of this process gives it back.  A token is a number that is looked up in a table,
// so this process never uses data from the network as an address.
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
  // A function that returns whether the peer has a region in memory; the bytes of such a region are
  // not sent.  A null function means that the peer has no region.
  using PeerHasMemory = std::function<bool(uint32_t region)>;

  // `makes_copies` is true in workers.  A received region may be new to the region table of a
  // worker, so the table then gets a copy of the region's memory.  `makes_copies` is false in the
  // master, because the master assigns region ids and so knows every region.
  Marshaller(System* system, bool makes_copies) : system_(system), makes_copies_(makes_copies) {}
  Marshaller(const Marshaller&) = delete;
  Marshaller& operator=(const Marshaller&) = delete;

  // Encodes `message`.  `peer_has` tells for which regions no bytes need to be sent.  `out` points
  // into `arena` and into the memory of regions, so both must stay unchanged until `out` has been
  // written.
  void Encode(const Message& message, const PeerHasMemory& peer_has, WireArena* arena,
              openr_wire_Message* out);

  // Releases the received regions that `message` gives back, if it is a ready message.  To be
  // called only when the peer has accepted the message, because after a refusal the observer keeps
  // its regions.
  void CompleteSend(const Message& message);

  // Decodes `in` into the new message `out`.  Leaves the message's class (MessageClass, which
  // decides its place in the queue) and its due time to the caller, because a sample has neither.
  // Returns "" or the error in `in`.  `in` must stay valid until ReleaseSample(), because changed
  // regions are found by comparing them with the bytes of `in`.
  std::string Decode(const openr_wire_Message& in, Message* out);
  void ReleaseSample();
  // Undoes the last Decode().  Called when the System of this process has refused the decoded
  // message, so that no object gets it.  If the message is a ready, the observer in the peer keeps
  // the regions that the ready was to give back, so they count as exported again.  If the message
  // is a notification, its regions do not count as imported any more.
  void UndoDecode();

  // Returns whether data of `region` were received from the peer and have not been given back to
  // it.  If so, observers may have changed the copy in this process, so this copy may be newer than
  // the memory in the peer.
  bool HasImported(uint32_t region) const;

  // Returns true if `region` was sent to the peer and the peer may still use the region.
  bool HasExported(uint32_t region) const;

  // A region that was sent to the peer and has not been given back.
  struct ExportedRegion {
    RCRegion* region;
    size_t size;
    int32_t subject;             // id of the object whose subject has sent the region
    uint32_t subject_selector;   // selector of this subject in its object
    int32_t observer;            // id of the object whose observer receives the region
    uint32_t observer_selector;  // selector of the receiving observer in its object
  };
  // Returns all regions that were sent to the peer and not given back, and forgets them.  Called
  // when the peer is lost, because a lost peer gives no region back.
  std::vector<ExportedRegion> TakeExported();
  // `subject` is the id of an object.  Returns the regions that the subjects of this object have
  // sent to the peer and that were not given back, and forgets them.  Called when the object was
  // replaced, because its regions are then released without waiting for the peer.  The peer may
  // still use these regions, so its later ready messages for them are accepted and ignored.
  std::vector<RCRegion*> TakeExportedBy(ObjectId subject);

  // Returns the tokens (numbers given by the peer) of regions that ReleaseImported() has released.
  // No ready message will give these regions back, so the peer can forget their tokens
  // (PeerDropped()).  Leaves out regions that still have memory in this process, because an object
  // may still use them.
  std::vector<uint64_t> TakeDroppedTokens();
  // Forgets regions of replaced objects (TakeExportedBy()) that the peer does not use any more.
  // `tokens` is the result of TakeDroppedTokens() in the peer.
  void PeerDropped(const std::vector<uint64_t>& tokens);

  // Forgets the tokens that stand for regions of the peer.  Called when the peer was lost, because
  // no ready message can then give these regions back to the peer.
  void PeerIsLost();

  // Releases a region that was received from the peer, without a ready message.  Called when the
  // object that sent the region was lost or replaced, because then no subject waits for the region.
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
    uint64_t token;  // the peer's token for the region; 0 if the peer is lost
    // The received bytes while the sample is valid, else null.  IsChanged() compares the region
    // with these bytes, or later with their `hash`.
    const uint8_t* bytes;
    uint64_t hash;
  };

  // Returns whether the observer has written into the region since the region was received.  If so,
  // the ready message sends the bytes of the region back.
  static bool IsChanged(const RCRegion& region, const ImportedRegion& imported);

  uint64_t last_token_ = 0;
  std::map<uint64_t, ExportedRegion> exported_;  // the key is the token of the region
  // Regions that TakeExportedBy() has returned and that the peer may still use.  The key is the
  // token under which the region was sent to the peer, the value is the region's memory id.  They
  // are kept so that a late ready message for such a region is not taken for an error.
  std::map<uint64_t, uint32_t> withdrawn_;
  // The imported regions; the key is the RCRegion in this process.  The order of pointers differs
  // from run to run, so loops over this map must give the same result in any order.
  std::map<RCRegion*, ImportedRegion> imported_;
  // The regions whose tokens TakeDroppedTokens() will return.  The key is the token (the peer's
  // number of the region), the value the memory id.
  std::map<uint64_t, uint32_t> dropped_;
  // The imported regions whose data lie in a received sample and were not copied: those with
  // ImportedRegion::bytes.
  std::vector<RCRegion*> sample_regions_;
  // The changes of the last Decode(), for UndoDecode(): the regions that Decode() has imported, and
  // the elements that Decode() has taken out of exported_ and withdrawn_.
  std::vector<RCRegion*> decoded_regions_;
  std::vector<std::map<uint64_t, ExportedRegion>::node_type> returned_;
  std::vector<std::map<uint64_t, uint32_t>::node_type> returned_withdrawn_;
};

}  // namespace openr_host
