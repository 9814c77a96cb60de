#include "Show.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include "SharedCount.h"

OStatus Show::DoInit(const OSystemEvent&) {
  NEW_ALL_SUBJECT_AND_OBSERVER;
  REGISTER_ALL_ENTRY;
  SET_ALL_READY_AND_NOTIFY_ENTRY;
  return oSUCCESS;
}

OStatus Show::DoStart(const OSystemEvent&) {
  observer[obsChanged]->AssertReady();
  return oSUCCESS;
}

OStatus Show::DoStop(const OSystemEvent&) { return oSUCCESS; }

OStatus Show::DoDestroy(const OSystemEvent&) {
  DELETE_ALL_SUBJECT_AND_OBSERVER;
  return oSUCCESS;
}

void Show::NotifyChanged(const ONotifyEvent& event) {
  OSYSLOG1((osyslogINFO, "state: shows %d", SharedCount::Get()));
  observer[event.ObsIndex()]->AssertReady();
}
