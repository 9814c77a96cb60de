// Shows what Tally has counted.
#ifndef Show_h_DEFINED
#define Show_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Show : public OObject {
 public:
  Show() {}
  virtual ~Show() {}

  OSubject* subject[numOfSubject];
  OObserver* observer[numOfObserver];

  virtual OStatus DoInit(const OSystemEvent& event);
  virtual OStatus DoStart(const OSystemEvent& event);
  virtual OStatus DoStop(const OSystemEvent& event);
  virtual OStatus DoDestroy(const OSystemEvent& event);

  void NotifyChanged(const ONotifyEvent& event);
};

#endif  // Show_h_DEFINED
