// OObject, the base of the C++ class of every object.
#ifndef OPENR_OOBJECT_H_INCLUDED
#define OPENR_OOBJECT_H_INCLUDED

#include <MCOOP.h>
#include <OPENR/OPENR.h>
#include <OPENR/OPENREvent.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/OSyslog.h>
#include <OPENR/ObjcommEvent.h>

class OObject {
 public:
  OObject();  // sets myOID_ to the OID of the object that is being loaded
  virtual ~OObject();

  // The stub, the generated code of the object, calls these four functions for the selectors 0 to
  // 3.  Init() calls DoInit() and reports the status of DoInit() to the object manager; the other
  // three functions do the same with DoStart(), DoStop() and DoDestroy().  The four functions are
  // inline, so that they are code of the image.  Otherwise DoInit() to DoDestroy() would run on the
  // stack for library functions and not on the stack of the object.
  void Init(const OSystemEvent& event) { ReplyStatus(DoInit(event)); }
  void Start(const OSystemEvent& event) { ReplyStatus(DoStart(event)); }
  void Stop(const OSystemEvent& event) { ReplyStatus(DoStop(event)); }
  void Destroy(const OSystemEvent& event) { ReplyStatus(DoDestroy(event)); }

  virtual OStatus DoInit(const OSystemEvent& event);
  virtual OStatus DoStart(const OSystemEvent& event);
  virtual OStatus DoStop(const OSystemEvent& event);
  virtual OStatus DoDestroy(const OSystemEvent& event);

 protected:
  // Registers the service `name` with the object manager, which connects services; returns
  // oALREADY_EXIST if the name is registered already.
  OStatus RegisterServiceEntry(const OServiceEntry& entry, const char* name);

  OID myOID_;

 private:
  static void ReplyStatus(OStatus status);

  OObject(const OObject&);
  OObject& operator=(const OObject&);
};

#endif  // OPENR_OOBJECT_H_INCLUDED
