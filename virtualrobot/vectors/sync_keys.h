// SyncKeys: the synchronisation keys of a robot, which make command and sound vectors start
// together.
//
// A key can be divided into parts.  Vectors that carry the parts of one key wait until the vectors
// of all parts have arrived.  If the vector of one part never comes, the other vectors wait until
// the key is cancelled; what the real robot does in this case is not known.
#pragma once

#include <OPENR/OPENR.h>

#include <array>
#include <string>

namespace openr_host {

class Hasher;

class SyncKeys {
 public:
  // Makes a synchronisation key and returns it.  Returns ovrsynckeyUNDEF when all keys are in use.
  OVRSyncKey New();

  // Ends `key`, so that all vectors with its parts may start.  Returns false when there is no such
  // key.
  bool Cancel(OVRSyncKey key);

  // Splits `key` into `key1` and `key2`.  Returns false when there is no such key, or when it
  // already has the maximum number of parts.
  bool Divide(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);

  // Records that the vector with `key`, the key of one part, has come to the front of its queue.
  // When the vectors of all parts have come to the front, all of them may start.
  void Arrive(OVRSyncKey key);
  // Returns whether a vector with `key` may start.  This is true for a key that does not exist, or
  // no longer exists.
  bool MayStart(OVRSyncKey key) const;

  // Returns a text for reports that says how many of the command vectors that belong to `key` have
  // come, such as "1 of 2 parts have come".
  std::string Progress(OVRSyncKey key) const;

  void HashState(Hasher* hasher) const;

 private:
  struct Group {
    bool alive = false;
    // Number of synchronisation keys that New() has made in this element of groups_.  The number is
    // part of each key, so an old key is not taken for the present key.
    longword serial = 0;
    int parts = 0;    // number of parts of the key: 1, and 1 more for each Divide()
    int arrived = 0;  // number of the key's parts whose vectors have arrived
  };
  // The bits of a key are serial << 8 | slot << 4 | part.  `slot` is the index of the key's Group
  // in groups_, and `serial` is Group::serial.  `part` is 0 in the key that New() returned;
  // Divide() gives the further keys that it makes from this key the numbers 1, 2 and so on.
  static constexpr int kSlots = ovrsynckeyMAX_NUM_KEY;
  Group* Find(OVRSyncKey key);
  const Group* Find(OVRSyncKey key) const { return const_cast<SyncKeys*>(this)->Find(key); }

  std::array<Group, kSlots> groups_;
};

}  // namespace openr_host
