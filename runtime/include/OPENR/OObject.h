// OObject: base of every core class.
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
  OObject();  // takes the OID the system gave to the object being loaded
  virtual ~OObject();

  // Called by the stub for selectors 0 to 3; each calls its DoXxx and reports
  // the status to the object manager.  They are compiled into the image, so that DoXxx is called
  // on the image's stack.
  void Init(const OSystemEvent& event) { ReplyStatus(DoInit(event)); }
  void Start(const OSystemEvent& event) { ReplyStatus(DoStart(event)); }
  void Stop(const OSystemEvent& event) { ReplyStatus(DoStop(event)); }
  void Destroy(const OSystemEvent& event) { ReplyStatus(DoDestroy(event)); }

  virtual OStatus DoInit(const OSystemEvent& event);
  virtual OStatus DoStart(const OSystemEvent& event);
  virtual OStatus DoStop(const OSystemEvent& event);
  virtual OStatus DoDestroy(const OSystemEvent& event);

 protected:
  // Makes `name` known to the service manager.  oALREADY_EXIST when it is.
  OStatus RegisterServiceEntry(const OServiceEntry& entry, const char* name);

  OID myOID_;

 private:
  static void ReplyStatus(OStatus status);

  OObject(const OObject&);
  OObject& operator=(const OObject&);
};

#endif  // OPENR_OOBJECT_H_INCLUDED
