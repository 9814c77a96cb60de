// Macros for the class of an object.  They use these members of the class: subject[], observer[],
// myOID_, RegisterServiceEntry(); and the tables of the generated entry.h.  Each macro is a block,
// written as "MACRO;" in a function.
#ifndef OPENR_CORE_MACRO_H_INCLUDED
#define OPENR_CORE_MACRO_H_INCLUDED

#include <OPENR/OPENR.h>

#include "entry.h"

// Makes every OSubject and OObserver of the object; must come before all other macros.
#define NEW_ALL_SUBJECT_AND_OBSERVER                                       \
  {                                                                        \
    for (int i = 0; i < numOfSubject; i++) subject[i] = new OSubject();    \
    for (int i = 0; i < numOfObserver; i++) observer[i] = new OObserver(); \
  }

// Registers the name of every service of the object with the object manager, which connects
// services.
#define REGISTER_ALL_ENTRY                                                               \
  {                                                                                      \
    for (int i = 0; i < numOfSubject; i++)                                               \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Control[i]), subjectService[i]);  \
    for (int i = 0; i < numOfObserver; i++)                                              \
      RegisterServiceEntry(OServiceEntry(myOID_, Entry_Connect[i]), observerService[i]); \
  }

// Sets the Ready entry of every subject of the object and the Notify entry of every observer.
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

// Does nothing, as in the SDK.
#define ENABLE_ALL_SUBJECT \
  {}

// Drops the data that wait in the subjects of the object.  NotifyObservers() still works
// afterwards.
#define DISABLE_ALL_SUBJECT                                           \
  {                                                                   \
    for (int i = 0; i < numOfSubject; i++) subject[i]->ClearBuffer(); \
  }

// Despite its name, this macro lets every observer of this object assert ready to its subjects.
#define ASSERT_READY_TO_ALL_OBSERVER                                    \
  {                                                                     \
    for (int i = 0; i < numOfObserver; i++) observer[i]->AssertReady(); \
  }
#define DEASSERT_READY_TO_ALL_OBSERVER                                    \
  {                                                                       \
    for (int i = 0; i < numOfObserver; i++) observer[i]->DeassertReady(); \
  }

// Does nothing, because the runtime deletes subjects and observers with the object.
#define DELETE_ALL_SUBJECT_AND_OBSERVER \
  {}

// Old names of macros in core_macro.h.
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
