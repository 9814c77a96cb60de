// OSubjectInfo: identifies one of the subjects with which an observer is connected.
#ifndef OPENR_OSUBJECTINFO_H_INCLUDED
#define OPENR_OSUBJECTINFO_H_INCLUDED

#include <OPENR/ObjcommTypes.h>

class OSubjectInfo : public SubjectID {
 public:
  OSubjectInfo() : version_(objcommVERSION_UNDEF) {}
  OSubjectInfo(const SubjectID& id, ObjcommVersion version) : SubjectID(id), version_(version) {}

  const SubjectID& GetSubjectID() const { return *this; }
  ObjcommVersion GetVersion() const { return version_; }

 private:
  ObjcommVersion version_;
};

typedef OSubjectInfo SubjectInfo;
typedef std::list<OSubjectInfo>::const_iterator SubjectConstIterator;

#endif  // OPENR_OSUBJECTINFO_H_INCLUDED
