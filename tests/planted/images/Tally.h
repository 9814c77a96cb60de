// Counts in a static, and tells the other object only that there is something new.
#ifndef Tally_h_DEFINED
#define Tally_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Tally : public OObject {
 public:
  Tally() {}
  virtual ~Tally() {}

  OSubject* subject[numOfSubject];
  OObserver* observer[numOfObserver];

  virtual OStatus DoInit(const OSystemEvent& event);
  virtual OStatus DoStart(const OSystemEvent& event);
  virtual OStatus DoStop(const OSystemEvent& event);
  virtual OStatus DoDestroy(const OSystemEvent& event);
};

#endif  // Tally_h_DEFINED
