// Synchronisation keys: command vectors that start together.
//
// A key can be divided; vectors that carry its parts wait until every part has
// arrived.  A part that never comes holds the others up until the key is cancelled: what
// the robot does then is not known.
#pragma once

#include <OPENR/OPENR.h>

#include <array>
#include <string>

namespace openr_host {

class Hasher;

class SyncKeys {
 public:
  // ovrsynckeyUNDEF when all keys are in use.
  OVRSyncKey New();
  bool Cancel(OVRSyncKey key);
  // Splits `key` in two; false when it does not exist or has all its parts.
  bool Divide(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);

  // A vector with this key came to the head of its queue.
  void Arrive(OVRSyncKey key);
  // Whether such a vector may start; true for keys that do not exist (any more).
  bool MayStart(OVRSyncKey key) const;

  // "1 of 2 parts have come", for messages to people.
  std::string Progress(OVRSyncKey key) const;

  void HashState(Hasher* hasher) const;

 private:
  struct Group {
    bool alive = false;
    longword serial = 0;  // tells the keys of this slot's successive groups apart
    int parts = 0;        // handed out
    int arrived = 0;
  };
  // A key: serial << 8 | slot << 4 | part.
  static constexpr int kSlots = ovrsynckeyMAX_NUM_KEY;
  Group* Find(OVRSyncKey key);
  const Group* Find(OVRSyncKey key) const { return const_cast<SyncKeys*>(this)->Find(key); }

  std::array<Group, kSlots> groups_;
};

}  // namespace openr_host
