// A variant of core_macro.h for a program that is started under another name, which the program
// stores in its variable `myname`.  The full name of a service begins with the name of the object,
// up to the first '.'.  The macros of this variant put `myname` in place of this name when they
// register a service.
#ifndef OPENR_CORE_MACRO2_H_INCLUDED
#define OPENR_CORE_MACRO2_H_INCLUDED

#include <OPENR/core_macro.h>

#include <string>

extern char myname[];

#undef REGISTER_ALL_ENTRY
#define REGISTER_ALL_ENTRY                                                                     \
  {                                                                                            \
    OStatus result = oSUCCESS;                                                                 \
    for (int i = 0; i < numOfSubject; i++) {                                                   \
      std::string name(subjectService[i]);                                                     \
      name.replace(0, name.find('.'), myname);                                                 \
      OStatus s = RegisterServiceEntry(OServiceEntry(myOID_, Entry_Control[i]), name.c_str()); \
      if (s != oSUCCESS) result = s;                                                           \
    }                                                                                          \
    for (int i = 0; i < numOfObserver; i++) {                                                  \
      std::string name(observerService[i]);                                                    \
      name.replace(0, name.find('.'), myname);                                                 \
      OStatus s = RegisterServiceEntry(OServiceEntry(myOID_, Entry_Connect[i]), name.c_str()); \
      if (s != oSUCCESS) result = s;                                                           \
    }                                                                                          \
    (void)result;                                                                              \
  }

#endif  // OPENR_CORE_MACRO2_H_INCLUDED
