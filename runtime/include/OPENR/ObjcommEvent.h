// The events that the class of an object receives: Connect, Control, Ready and Notify.
//
// For each message, the stub (the generated code of an object) makes an event and passes the event
// to a function of the class.  Programs may keep copies of an event, but the data to which the
// event points do not stay valid (see ONotifyEvent).
#ifndef OPENR_OBJCOMMEVENT_H_INCLUDED
#define OPENR_OBJCOMMEVENT_H_INCLUDED

#include <OPENR/OSubjectInfo.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/ObjcommTypes.h>
#include <OPENR/RCRegion.h>

// Tells the subject with the index SbjIndex() that an observer asks to be added to the subject's
// observers, or to be removed from them.
class OControlEvent {
 public:
  OControlEvent(int index, char* subName, ObjcommCommand command)
      : index_(index), subName_(subName), command_(command) {}
  OControlEvent(int index, ObserverID id, char* subName, ObjcommCommand command)
      : index_(index), id_(id), subName_(subName), command_(command) {}

  int SbjIndex() const { return index_; }
  const char* SubName() const { return subName_; }  // full name of the service at the other end
  const ObserverID& SenderID() const { return id_; }
  bool IsAddObserver() const {
    return command_ == objcommCMD_ADDOBSERVER || command_ == objcommCMD_ADDOBSERVER_SELF ||
           command_ == objcommCMD_ADDOBSERVER_V22;
  }
  bool IsRemoveObserver() const {
    return command_ == objcommCMD_REMOVEOBSERVER || command_ == objcommCMD_REMOVEOBSERVER_SELF ||
           command_ == objcommCMD_REMOVEOBSERVER_V22;
  }

 private:
  int index_;
  ObserverID id_;
  char* subName_;
  ObjcommCommand command_;
};

// Tells the observer with the index ObsIndex() that the object manager asks the observer to connect
// to a subject, or to disconnect.
class OConnectEvent {
 public:
  OConnectEvent(int index, char* subName, OConnectCmd command)
      : index_(index), subName_(subName), command_(command) {}

  int ObsIndex() const { return index_; }
  const char* SubName() const { return subName_; }
  bool IsConnect() const { return command_ == oconnectcmdCONNECT; }
  bool IsDisconnect() const {
    return command_ == oconnectcmdDISCONNECT || command_ == oconnectcmdDISCONNECTALL;
  }

 private:
  int index_;
  char* subName_;
  OConnectCmd command_;
};

// Tells the subject with the index SbjIndex() that one of its observers has asserted or deasserted
// ready.
class OReadyEvent {
 public:
  OReadyEvent(int index, ObserverID id, ObjcommCommand command)
      : index_(index), id_(id), command_(command) {}

  int SbjIndex() const { return index_; }
  const ObserverID& SenderID() const { return id_; }
  bool IsAssert() const { return command_ == objcommCMD_ASSERT_READY; }
  bool IsDeassert() const { return command_ == objcommCMD_DEASSERT_READY; }

 private:
  int index_;
  ObserverID id_;
  ObjcommCommand command_;
};

// Data from one subject.  Data(i) and RCData(i) stay valid until the observer asserts or deasserts
// ready to that subject, and longer for a region whose AddReference() was called.
class ONotifyEvent {
 public:
  ONotifyEvent() : index_(-1), numOfData_(0), numOfNotify_(0) {}

  int ObsIndex() const { return index_; }
  const OSubjectInfo& SenderID() const { return sender_; }
  int NumOfData() const { return numOfData_; }
  int NumOfNotify() const { return numOfNotify_; }

  // Return the data with index i, 0 <= i < NumOfData(); Data() without an index returns an array of
  // the addresses of all data.
  const void* Data(int i) const { return rcr_[i]->Base(); }
  const void** Data() const {
    for (int i = 0; i < numOfData_; ++i) data_[i] = rcr_[i]->Base();
    return data_;
  }
  RCRegion* RCData(int i) const { return rcr_[i]; }

  void SetIndex(int index) { index_ = index; }
  void SetSubjectInfo(const OSubjectInfo& info) { sender_ = info; }
  void SetNumOfData(int n) { numOfData_ = n; }
  void SetNumOfNotify(int n) { numOfNotify_ = n; }
  void SetData(int i, RCRegion* region) { rcr_[i] = region; }

 private:
  int index_;
  OSubjectInfo sender_;
  int numOfData_;
  int numOfNotify_;
  RCRegion* rcr_[MAX_NUM_DATA];
  mutable const void* data_[MAX_NUM_DATA];
};

#endif  // OPENR_OBJCOMMEVENT_H_INCLUDED
