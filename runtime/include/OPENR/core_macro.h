// Macros for core classes.  They use these names of the class that expands
// them: subject[], observer[], myOID_, RegisterServiceEntry(); and the tables of
// the generated entry.h.  Each is a plain block, written MACRO; in a function.
#ifndef OPENR_CORE_MACRO_H_INCLUDED
#define OPENR_CORE_MACRO_H_INCLUDED

#include <OPENR/OPENR.h>

#include "entry.h"

// First of all: makes every OSubject and OObserver.
#define NEW_ALL_SUBJECT_AND_OBSERVER                                       \
  {                                                                        \
    for (int i = 0; i < numOfSubject; i++) subject[i] = new OSubject();    \
    for (int i = 0; i < numOfObserver; i++) observer[i] = new OObserver(); \
  }

// Tells the service manager the name of every service.
#define REGISTER_ALL_ENTRY                                                               \
  {                                                                                      \
    for (int i = 0; i < numOfSubject; i++)                                               \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Control[i]), subjectService[i]);  \
    for (int i = 0; i < numOfObserver; i++)                                              \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Connect[i]), observerService[i]); \
  }

// Tells every subject and observer its entry.
#define SET_ALL_READY_AND_NOTIFY_ENTRY        \
  {                                           \
    OServiceEntry entry;                      \
    for (int i = 0; i < numOfSubject; i++) {  \
      entry.Set(myOID_, Entry_Ready[i]);      \
      subject[i]->SetReadyEntry(entry);       \
    }                                         \
    for (int i = 0; i < numOfObserver; i++) { \
      entry.Set(myOID_, Entry_Notify[i]);     \
      observer[i]->SetNotifyEntry(entry);     \
    }                                         \
  }

// Nothing to do; the SDK left it empty as well.
#define ENABLE_ALL_SUBJECT \
  {}

// Drops data that wait in the subjects.  NotifyObservers() still works after it.
#define DISABLE_ALL_SUBJECT                                           \
  {                                                                   \
    for (int i = 0; i < numOfSubject; i++) subject[i]->ClearBuffer(); \
  }

// Despite the name: every observer of this object tells its subjects that it is ready.
#define ASSERT_READY_TO_ALL_OBSERVER                                    \
  {                                                                     \
    for (int i = 0; i < numOfObserver; i++) observer[i]->AssertReady(); \
  }
#define DEASSERT_READY_TO_ALL_OBSERVER                                    \
  {                                                                       \
    for (int i = 0; i < numOfObserver; i++) observer[i]->DeassertReady(); \
  }

// Nothing to do; the runtime frees them with the object.
#define DELETE_ALL_SUBJECT_AND_OBSERVER \
  {}

// Old names.
#define ASSERT_TO_ALL_OBSERVER ASSERT_READY_TO_ALL_OBSERVER
#define DEASSERT_TO_ALL_OBSERVER DEASSERT_READY_TO_ALL_OBSERVER
#define NewComData NEW_ALL_SUBJECT_AND_OBSERVER
#define DeleteComData DELETE_ALL_SUBJECT_AND_OBSERVER
#define SetComData                 \
  {                                \
    REGISTER_ALL_ENTRY             \
    SET_ALL_READY_AND_NOTIFY_ENTRY \
  }

#endif  // OPENR_CORE_MACRO_H_INCLUDED
