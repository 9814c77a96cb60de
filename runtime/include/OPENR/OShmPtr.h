// OShmPtr<T>, a smart pointer to an array of T in an RCRegion.
//
// Reading copies nothing.  Writing through a Proxy first copies the region if there are other
// references to it.  T must be plain data, because no constructor or destructor of T runs.
#ifndef OPENR_OSHMPTR_H_INCLUDED
#define OPENR_OSHMPTR_H_INCLUDED

#include <OPENR/RCRegion.h>

class OShmPtrBase {
 public:
  OShmPtrBase() : region_(0) {}
  OShmPtrBase(const OShmPtrBase& other) : region_(other.region_) { Refer(); }
  explicit OShmPtrBase(RCRegion* region) : region_(region) { Refer(); }
  virtual ~OShmPtrBase() { Deallocate(); }

  const OShmPtrBase& operator=(const OShmPtrBase& other) {
    if (region_ != other.region_) {
      Deallocate();
      region_ = other.region_;
      Refer();
    }
    return *this;
  }

  // Releases the reference of this smart pointer to its region.
  void Deallocate() {
    if (region_ != 0) region_->RemoveReference();
    region_ = 0;
  }

  char* BaseAddress() const { return region_ == 0 ? 0 : region_->Base(); }
  char* Base() const { return BaseAddress(); }
  size_t Size() const { return region_ == 0 ? 0 : region_->Size(); }
  RCRegion* RCRPtr() const { return region_; }
  MemoryRegionID MemID() const { return region_ == 0 ? 0 : region_->MemID(); }
  unsigned Offset() const { return region_ == 0 ? 0 : region_->Offset(); }

 protected:
  // Makes this smart pointer refer to `region`, a new region, instead of its old region.  REQUIRES:
  // the caller has the only reference to `region`; this smart pointer takes over that reference.
  void Own(RCRegion* region) {
    Deallocate();
    region_ = region;
  }
  // Makes sure that this smart pointer has the only reference to its region: copies the region if
  // there are other references.
  void Unshare() {
    if (region_ == 0 || region_->NumberOfReference() <= 1) return;
    RCRegion* copy = new RCRegion(region_->Size());
    ::memcpy(copy->Base(), region_->Base(), region_->Size());
    Own(copy);
  }

  RCRegion* region_;

 private:
  void Refer() {
    if (region_ != 0) region_->AddReference();
  }
};

template <class T>
class OShmPtr : public OShmPtrBase {
 public:
  // A reference to one element of the array of this smart pointer.  Writing to the element first
  // copies the region if there are other references to the region.
  class Proxy {
   public:
    Proxy(OShmPtr<T>* owner, int index) : owner_(owner), index_(index) {}
    operator const T&() const { return owner_->Element(index_); }
    const T& operator=(const T& value) {
      owner_->Unshare();
      return owner_->Element(index_) = value;
    }
    const T& operator=(const Proxy& other) { return *this = static_cast<const T&>(other); }
    Proxy(const Proxy& other) : owner_(other.owner_), index_(other.index_) {}

   private:
    OShmPtr<T>* owner_;
    int index_;
  };
  friend class Proxy;

  OShmPtr() {}
  explicit OShmPtr(size_t n) { Allocate(static_cast<int>(n)); }
  OShmPtr(const OShmPtrBase& other) : OShmPtrBase(other) {}
  OShmPtr(const OShmPtr& other) : OShmPtrBase(other) {}
  explicit OShmPtr(RCRegion* region) : OShmPtrBase(region) {}

  OShmPtr& operator=(const OShmPtrBase& other) {
    OShmPtrBase::operator=(other);
    return *this;
  }
  OShmPtr& operator=(const OShmPtr& other) {
    OShmPtrBase::operator=(other);
    return *this;
  }

  const T& operator*() const { return Element(0); }
  const T& operator[](int i) const { return Element(i); }
  Proxy operator*() { return Proxy(this, 0); }
  Proxy operator[](int i) { return Proxy(this, i); }
  const T* operator->() { return &Element(0); }
  const T* operator->() const { return &Element(0); }

  int NumOfElement() const { return static_cast<int>(OShmPtrBase::Size() / sizeof(T)); }
  int Size() const { return NumOfElement(); }

  // Writes `size` bytes from `source` to the start of the region of this smart pointer; first
  // copies the region if there are other references to it.
  void Copy(const void* source, size_t size) {
    Unshare();
    ::memcpy(Base(), source, size);
  }
  void Allocate(int n = 1) { Own(new RCRegion(static_cast<size_t>(n) * sizeof(T))); }
  void AllocateCopy(size_t size, void* source) {
    Own(new RCRegion(size));
    ::memcpy(Base(), source, size);
  }

 private:
  T& Element(int i) const { return reinterpret_cast<T*>(Base())[i]; }
};

inline void* memcpy(void* destination, const OShmPtrBase& source, size_t size) {
  return ::memcpy(destination, source.Base(), size);
}
template <class T>
inline void memcpy(OShmPtr<T>& destination, const void* source, size_t size) {
  destination.Copy(source, size);
}

#endif  // OPENR_OSHMPTR_H_INCLUDED
