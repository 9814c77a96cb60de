#include "Tally.h"

#include <OPENR/core_macro.h>

#include "SharedCount.h"

OStatus Tally::DoInit(const OSystemEvent&) {
  NEW_ALL_SUBJECT_AND_OBSERVER;
  REGISTER_ALL_ENTRY;
  SET_ALL_READY_AND_NOTIFY_ENTRY;
  return oSUCCESS;
}

OStatus Tally::DoStart(const OSystemEvent&) {
  const char hint = 1;
  SharedCount::Get() = 42;
  subject[sbjChanged]->SetData(&hint, sizeof(hint));
  subject[sbjChanged]->NotifyObservers();
  return oSUCCESS;
}

OStatus Tally::DoStop(const OSystemEvent&) { return oSUCCESS; }

OStatus Tally::DoDestroy(const OSystemEvent&) {
  DELETE_ALL_SUBJECT_AND_OBSERVER;
  return oSUCCESS;
}
