// AcceptAll(), which accepts the connections that wait, or closes them if this process can open no
// more descriptors.
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <utility>

namespace openr_host {

// SpareDescriptor: a file descriptor that is kept in reserve.  When this process can open no more
// descriptors, CloseNext() closes the reserve for a moment, so that it can accept and close the
// connection that waits.  A connection that stays in the queue of the listener would make the event
// loop find the listener readable again and again.
class SpareDescriptor {
 public:
  // `pause` waits a moment.  It is called when a connection can neither be accepted nor closed,
  // because the event loop finds the listener readable again at once.
  explicit SpareDescriptor(std::function<void()> pause) : pause_(std::move(pause)) { Open(); }
  ~SpareDescriptor() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  SpareDescriptor(const SpareDescriptor&) = delete;
  SpareDescriptor& operator=(const SpareDescriptor&) = delete;

  // Opens the spare descriptor again if CloseNext() could not, because another thread had taken the
  // last descriptor.  Called before connections are accepted, which may need all descriptors that
  // are free.
  void OpenAgain() {
    if (descriptor_ < 0) Open();
  }

  // Closes the next connection that waits at `listener`.  Returns false if no connection waits, or
  // if the spare descriptor could not be opened again.
  bool CloseNext(int listener) {
    OpenAgain();
    if (descriptor_ < 0) {
      pause_();
      return false;
    }
    close(descriptor_);
    const int connection = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (connection >= 0) close(connection);
    Open();
    return connection >= 0;
  }

 private:
  void Open() { descriptor_ = open("/dev/null", O_RDONLY | O_CLOEXEC); }

  const std::function<void()> pause_;
  int descriptor_;
};

// Accepts all connections that wait at `listener`, and gives each to `take`.  Always returns true,
// because a Listener whose function returns false is closed.
inline bool AcceptAll(int listener, SpareDescriptor* spare,
                      const std::function<void(int connection)>& take) {
  spare->OpenAgain();
  for (;;) {
    const int connection = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (connection >= 0) {
      take(connection);
    } else if ((errno != EMFILE && errno != ENFILE) || !spare->CloseNext(listener)) {
      return true;
    }
  }
}

}  // namespace openr_host
