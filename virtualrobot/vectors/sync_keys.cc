#include "virtualrobot/vectors/sync_keys.h"

#include <fmt/format.h>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {

SyncKeys::Group* SyncKeys::Find(OVRSyncKey key) {
  if (key == ovrsynckeyUNDEF) return nullptr;
  const longword slot = key >> 4 & 0xf;
  if (slot >= static_cast<longword>(kSlots)) return nullptr;
  Group& group = groups_[slot];
  return group.alive && group.serial == key >> 8 ? &group : nullptr;
}

OVRSyncKey SyncKeys::New() {
  for (longword slot = 0; slot < static_cast<longword>(kSlots); ++slot) {
    Group& group = groups_[slot];
    if (group.alive) continue;
    group = {true, (group.serial + 1) & 0xffffff, 1, 0};
    return group.serial << 8 | slot << 4;
  }
  return ovrsynckeyUNDEF;
}

bool SyncKeys::Cancel(OVRSyncKey key) {
  Group* const group = Find(key);
  if (group == nullptr) return false;
  group->alive = false;
  return true;
}

bool SyncKeys::Divide(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  Group* const group = Find(key);
  if (group == nullptr || group->parts >= static_cast<int>(ovrsynckeyMAX_NUM_DIVISION))
    return false;
  *key1 = key;
  *key2 = (key & ~longword{0xf}) | static_cast<longword>(group->parts);
  ++group->parts;
  return true;
}

void SyncKeys::Arrive(OVRSyncKey key) {
  Group* const group = Find(key);
  if (group == nullptr) return;
  ++group->arrived;
  ASSERT(group->arrived <= group->parts, "{} of {} parts", group->arrived, group->parts);
  // Ends the key when vectors with all its parts have arrived.  From then on MayStart() returns
  // true for these vectors, so they start together.
  if (group->arrived == group->parts) group->alive = false;
}

bool SyncKeys::MayStart(OVRSyncKey key) const { return Find(key) == nullptr; }

std::string SyncKeys::Progress(OVRSyncKey key) const {
  const Group* const group = Find(key);
  if (group == nullptr) return "no such key";
  return fmt::format("{} of {} parts have come", group->arrived, group->parts);
}

void SyncKeys::HashState(Hasher* hasher) const {
  for (const Group& group : groups_) {
    hasher->Add(group.alive);
    hasher->Add(group.serial);
    hasher->Add(group.parts);
    hasher->Add(group.arrived);
  }
}

}  // namespace openr_host
