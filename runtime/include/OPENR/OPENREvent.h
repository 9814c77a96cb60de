// The argument of DoInit, DoStart, DoStop and DoDestroy.
#ifndef OPENR_OPENREVENT_H_INCLUDED
#define OPENR_OPENREVENT_H_INCLUDED

#include <OPENR/OPENR.h>

class OSystemEvent {
 public:
  // `param` points to the parameter of DoInit, DoStart, DoStop or DoDestroy.  The caller owns the
  // parameter and must keep it as long as this event exists.
  OSystemEvent(OReason reason, void* param, size_t paramSize)
      : reason_(reason), param_(param), paramSize_(paramSize) {}

  OReason Reason() const { return reason_; }

  // Returns an OBootParam or an OShutdownParam of ParamSize() bytes, which is valid only until the
  // function that received this event returns.
  const void* Param() const { return param_; }
  size_t ParamSize() const { return paramSize_; }

 private:
  OReason reason_;
  void* param_;
  size_t paramSize_;
};

#include <OPENR/OMemoryLocator.h>
#include <OPENR/ObjcommEvent.h>

#endif  // OPENR_OPENREVENT_H_INCLUDED
