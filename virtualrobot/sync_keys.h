// Synchronisation keys: command vectors that start together.
//
// A key can be divided into parts.  Vectors that carry the parts wait until the vectors of all
// parts have arrived.  If the vector of one part never comes, the others wait until the key is
// cancelled; what the robot does in this case is not known.
#pragma once

#include <OPENR/OPENR.h>

#include <array>
#include <string>

namespace openr_host {

class Hasher;

class SyncKeys {
 public:
  // Makes a key.  Returns ovrsynckeyUNDEF when all keys are in use.
  OVRSyncKey New();

  // Ends a key, so that all vectors with its parts may start.  Returns false when there is no such
  // key.
  bool Cancel(OVRSyncKey key);

  // Splits `key` in two.  Returns false when there is no such key, or when it has as many parts as
  // a key may have.
  bool Divide(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);

  // Tells that a vector with this key is the first of its queue now.
  void Arrive(OVRSyncKey key);
  // Whether a vector with this key may start.  True for keys that do not exist, or exist no more.
  bool MayStart(OVRSyncKey key) const;

  // A text for reports: "1 of 2 parts have come".
  std::string Progress(OVRSyncKey key) const;

  void HashState(Hasher* hasher) const;

 private:
  struct Group {
    bool alive = false;
    longword serial = 0;  // number of groups that have used this slot, so that old keys are known
    int parts = 0;        // keys made by New() and Divide()
    int arrived = 0;      // <= parts
  };
  // A key is serial << 8 | slot << 4 | part.
  static constexpr int kSlots = ovrsynckeyMAX_NUM_KEY;
  Group* Find(OVRSyncKey key);
  const Group* Find(OVRSyncKey key) const { return const_cast<SyncKeys*>(this)->Find(key); }

  std::array<Group, kSlots> groups_;
};

}  // namespace openr_host
