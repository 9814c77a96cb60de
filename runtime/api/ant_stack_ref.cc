#include <MCOOP.h>
#include <antStackRef.h>

// If no object has that name, Find() leaves oid_ invalid.
antStackRef::antStackRef(const char* name) {
  dispatcher_ = nullptr;
  Find(name, &oid_);
}
