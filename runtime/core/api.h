// Converts between ObjectId, the index of an object in its System, and OID, the robot's identifier
// of an object.  Used by the functions of the SDK.
#pragma once

#include <OID.h>

#include "runtime/core/current.h"
#include "runtime/core/message.h"

namespace openr_host {

// The OID of object 0.  With this number, programs see OIDs as on a real robot: in the published
// lists of the objects of real robots, the first objects of an application have OIDs from this
// number on (field-notes.md, 1.5).
constexpr uintptr_t kFirstOid = 0x80000042;

inline uintptr_t OidValue(ObjectId id) { return kFirstOid + static_cast<uintptr_t>(id); }
inline OID OidOf(ObjectId id) { return OID(reinterpret_cast<void*>(OidValue(id))); }
inline ObjectId ObjectIdOf(const OID& oid) {
  const auto value = reinterpret_cast<uintptr_t>(oid.GetAddress());
  return value < kFirstOid || value > kFirstOid + 0xffffff
             ? kNoObject
             : static_cast<ObjectId>(value - kFirstOid);
}

}  // namespace openr_host
