#include <MCOOP.h>
#include <antStackRef.h>

// Finds a network stack by the name of its object.  If there is no object `name`, oid_ stays
// invalid, and Send() and Call() to this stack fail.
antStackRef::antStackRef(const char* name) {
  dispatcher_ = nullptr;
  Find(name, &oid_);
}
