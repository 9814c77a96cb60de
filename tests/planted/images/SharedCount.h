// Fault: a static that two objects are meant to share.  Each image has its own.
#ifndef SharedCount_h_DEFINED
#define SharedCount_h_DEFINED

class SharedCount {
 public:
  static int& Get() {
    static int count = 0;
    return count;
  }
};

#endif  // SharedCount_h_DEFINED
