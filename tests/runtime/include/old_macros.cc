// The macros of core_macro.h and core_macro2.h under their old and new names, as programs of
// remote processing use them; checked by the compiler only.
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <OPENR/core_macro.h>
#include <OPENR/core_macro2.h>

char myname[] = "Renamed";

class OldMacros : public OObject {
 public:
  OSubject* subject[numOfSubject];
  OObserver* observer[numOfObserver];

  void Begin() {
    NewComData;
    REGISTER_ALL_ENTRY;
    SetComData;
    ENABLE_ALL_SUBJECT;
    ASSERT_TO_ALL_OBSERVER;
    ASSERT_READY_TO_ALL_OBSERVER;
  }
  void End() {
    DISABLE_ALL_SUBJECT;
    DEASSERT_TO_ALL_OBSERVER;
    DEASSERT_READY_TO_ALL_OBSERVER;
    DeleteComData;
    DELETE_ALL_SUBJECT_AND_OBSERVER;
  }
};
