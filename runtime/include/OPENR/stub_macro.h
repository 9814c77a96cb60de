// The macros from which a generated stub is built.
//
// Each StubFuncDefine_* defines one extern "C" function, which converts a message to a call of the
// object's class, whose only instance is `Self`.  The functions do not call Exit(), because a
// handler ends when its function returns.
#ifndef OPENR_STUB_MACRO_H_INCLUDED
#define OPENR_STUB_MACRO_H_INCLUDED

#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommEvent.h>
#include <OPENR/ObjcommMessages.h>

// Makes data of the stub visible outside of the image, because the host's loader looks up these
// data by name.
#define OPENR_HOST_EXPORT __attribute__((visibility("default")))

typedef void (*_Hook)(OReasonMessage*);
typedef void (*_Control)(OControlMessage*);
typedef void (*_Ready)(OReadyMessage*);
typedef void (*_Connect)(OConnectMessage*);
typedef void (*_Notify)(ONotifyMessage*);

#define _Hook(n) _##n
#define _Control(n) _Control##n
#define _Ready(n) _Ready##n
#define _Connect(n) _Connect##n
#define _Notify(n) _Notify##n

#define StubFuncDeclare_Basic(n) void _Hook(n)(OReasonMessage * msg);
#define StubFuncDeclare_Subject(i)         \
  void _Control(i)(OControlMessage * msg); \
  void _Ready(i)(OReadyMessage * msg);
#define StubFuncDeclare_Observer(i)        \
  void _Connect(i)(OConnectMessage * msg); \
  void _Notify(i)(ONotifyMessage * msg);

#define StubFuncDefine_Basic(n)                                    \
  extern "C" void _Hook(n)(OReasonMessage * msg) {                 \
    Self.n(OSystemEvent(msg->reason, msg->param, msg->paramSize)); \
  }

#define StubFuncDefine_Control(i, f)                                                        \
  extern "C" void _Control(i)(OControlMessage * msg) {                                      \
    OStatus status = Self.f(OControlEvent(i, msg->observerID, msg->subName, msg->command)); \
    Self.subject[i]->ControlHandler(*msg, status);                                          \
  }
#define StubFuncDefine_Control_nofunc(i) \
  extern "C" void _Control(i)(OControlMessage * msg) { Self.subject[i]->ControlHandler(*msg); }

// Lets the subject handle the ready message first.  So the subject sends its waiting notifications
// before the program's function for this message is called.
#define StubFuncDefine_Ready(i, f)                         \
  extern "C" void _Ready(i)(OReadyMessage * msg) {         \
    Self.subject[i]->ReadyHandler(*msg);                   \
    Self.f(OReadyEvent(i, msg->observerID, msg->command)); \
  }
#define StubFuncDefine_Ready_nofunc(i) \
  extern "C" void _Ready(i)(OReadyMessage * msg) { Self.subject[i]->ReadyHandler(*msg); }

#define StubFuncDefine_Connect(i, f)                                       \
  extern "C" void _Connect(i)(OConnectMessage * msg) {                     \
    OStatus status = Self.f(OConnectEvent(i, msg->subName, msg->command)); \
    Self.observer[i]->ConnectHandler(*msg, status);                        \
  }
#define StubFuncDefine_Connect_nofunc(i) \
  extern "C" void _Connect(i)(OConnectMessage * msg) { Self.observer[i]->ConnectHandler(*msg); }

#define StubFuncDefine_Notify(i, f)                  \
  extern "C" void _Notify(i)(ONotifyMessage * msg) { \
    ONotifyEvent event;                              \
    event.SetIndex(i);                               \
    Self.observer[i]->NotifyHandler(*msg, &event);   \
    Self.f(event);                                   \
  }
#define StubFuncDefine_Notify_nofunc(i)              \
  extern "C" void _Notify(i)(ONotifyMessage * msg) { \
    ONotifyEvent event;                              \
    event.SetIndex(i);                               \
    Self.observer[i]->NotifyHandler(*msg, &event);   \
  }

#endif  // OPENR_STUB_MACRO_H_INCLUDED
