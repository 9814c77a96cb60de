// OObject, from which the C++ class of every object of a program is derived.
#include <OPENR/OObject.h>

#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/requests.h"
#include "runtime/core/system.h"

using namespace openr_host;

OObject::OObject() : myOID_(t_current.object == nullptr ? OID() : OidOf(t_current.object->id)) {}
OObject::~OObject() = default;

void OObject::ReplyStatus(OStatus status) {
  const ApiScope scope;
  OStatusMessage message(status);
  ReplyToRequest(&message, sizeof message);
}

OStatus OObject::DoInit(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStart(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStop(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoDestroy(const OSystemEvent&) { return oSUCCESS; }

OStatus OObject::RegisterServiceEntry(const OServiceEntry& entry, const char* name) {
  const ApiScope scope;
  ASSERT(t_current.object != nullptr, "RegisterServiceEntry() is called by the code of an object");
  if (name == nullptr || std::strlen(name) > oserviceNAME_MAX) return oFAIL;
  return t_current.system->calls().RegisterService(ObjectIdOf(entry.GetOID()), entry.GetSelector(),
                                                   name);
}
