// OObject: what every core class inherits.
#include <OPENR/OObject.h>

#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

using namespace openr_host;

OObject::OObject() : myOID_(t_current.object == nullptr ? OID() : OidOf(t_current.object->id)) {}
OObject::~OObject() = default;

void OObject::ReplyStatus(OStatus status) {
  const ApiScope scope;
  OStatusMessage message(status);
  Reply(&message, sizeof message);
}

OStatus OObject::DoInit(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStart(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoStop(const OSystemEvent&) { return oSUCCESS; }
OStatus OObject::DoDestroy(const OSystemEvent&) { return oSUCCESS; }

OStatus OObject::RegisterServiceEntry(const OServiceEntry& entry, const char* name) {
  const ApiScope scope;
  openr_host::Object* const object = t_current.object;
  ASSERT(object != nullptr, "RegisterServiceEntry() is called by the code of an object");
  if (name == nullptr || std::strlen(name) > oserviceNAME_MAX) return oFAIL;
  if (Uplink* const uplink = t_current.system->uplink()) {
    const auto target = static_cast<uint64_t>(ObjectIdOf(entry.GetOID()));
    const Answer answer =
        uplink->Ask({QuestionKind::kRegisterService, {target, entry.GetSelector()}, name});
    if (answer.status == oSUCCESS) object->services[entry.GetSelector()] = name;
    return static_cast<OStatus>(answer.status);
  }
  auto& directory = t_current.system->robot(object->robot).directory;
  const bool is_new =
      directory.emplace(name, std::pair(ObjectIdOf(entry.GetOID()), entry.GetSelector())).second;
  if (!is_new) return oALREADY_EXIST;
  object->services[entry.GetSelector()] = name;
  return oSUCCESS;
}
