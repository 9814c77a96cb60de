// The interface of libopenr_panel.so: an event loop with HTTP and WebSockets.
//
// The implementation is web_loop.cc, the only file that includes libwebsockets.  Only `openr panel`
// loads this library, so that a simulation never has the code of libwebsockets and OpenSSL in its
// process.  All functions are called in one thread, but WebLoop::Wake() may be called in any
// thread.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openr_host {

// A request of HTTP.  A WebSocket begins with such a request, too.
struct WebRequest {
  bool is_get = false;
  std::string path;      // path in the URL, such as "/index.html", decoded and without the query
  std::string host;      // header Host; "" if the request has none
  std::string origin;    // header Origin; "" if the request has none
  std::string protocol;  // header Sec-WebSocket-Protocol; "" if the request has none
  std::string run;       // value of "run=" in the query of the URL; "" if there is none
};

// An answer to a request of HTTP.  Its bytes are the content of `file`; if `file` is "", they are
// `text`.
struct WebAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string text = {};
  std::string file = {};
  // Names and values of headers; names in lower case.
  std::vector<std::pair<std::string, std::string>> headers = {};
};

// The connection of a WebSocket to its page.  A WebPage uses this connection to send messages, to
// stop reading, and to close the WebSocket.
class WebConnection {
 public:
  // Makes the event loop call WebPage::Next() as soon as the socket can take bytes.
  virtual void WantWrite() = 0;
  // Closes the WebSocket with `code` and `why` (RFC 6455, section 7.4) as soon as WebPage::Next()
  // returns "", so that waiting messages are sent before.
  virtual void CloseWhenSent(int code, const std::string& why) = 0;
  // Closes the socket of the page at once, and sends no reason to the page.
  virtual void Abort() = 0;
  // Begins to read from the page again if `is_on` is true, and stops reading if it is false.
  virtual void SetReading(bool is_on) = 0;

 protected:
  ~WebConnection() = default;
};

// The server's end of a WebSocket; the other end is a page in a browser.
class WebPage {
 public:
  virtual ~WebPage() = default;
  // Receives a part of a message from the page.  `is_last` says that the message is complete.
  virtual void ReceivePart(std::string_view part, bool is_text, bool is_last) = 0;
  // Returns the next message for the page; "" if none waits.
  virtual std::string Next() = 0;
};

// A descriptor that the event loop watches.
class WebDescriptor {
 public:
  // Called when the descriptor can be read.  Returns false if the descriptor must be closed.
  virtual bool OnReadable() = 0;
  // Called after WebLoop::WantWrite(), when the descriptor can be written.  Returns false if the
  // descriptor must be closed.
  virtual bool OnWritable() { return true; }
  // Called once after the event loop has closed the descriptor, unless Forget() was called before.
  virtual void OnClosed() = 0;

 protected:
  ~WebDescriptor() = default;
};

// The functions of the panel's server that the event loop calls.
class WebService {
 public:
  virtual WebAnswer Answer(const WebRequest& request) = 0;
  // Returns the answer that refuses to open the WebSocket of a page; null if the WebSocket may be
  // opened.
  virtual std::unique_ptr<WebAnswer> Refuse(const WebRequest& request) = 0;
  // Called when a WebSocket was opened.  `connection` exists as long as the page that this function
  // returns.
  virtual std::unique_ptr<WebPage> Open(const WebRequest& request, WebConnection* connection) = 0;
  // Called in the thread of the event loop after a thread has called WebLoop::Wake().
  virtual void OnWake() = 0;

 protected:
  ~WebService() = default;
};

class WebLoop {
 public:
  virtual ~WebLoop() = default;

  // Serves pages until Stop() is called.
  virtual void Run() = 0;
  virtual void Stop() = 0;
  // Calls Stop() after `ms` milliseconds.
  virtual void StopAfter(int ms) = 0;

  // Makes Run() call WebService::OnWake().  May be called in any thread.
  virtual void Wake() = 0;

  // Serves HTTP on the socket `connection`, which a client has opened.  The event loop owns the
  // descriptor from now on.
  virtual void Serve(int connection) = 0;

  // A handle for a descriptor that the event loop watches; null after an error.
  using Watched = void*;
  // Watches a descriptor and calls `handler` for it.  The event loop owns the descriptor from now
  // on.
  virtual Watched Watch(int descriptor, WebDescriptor* handler) = 0;
  virtual void WantWrite(Watched watched) = 0;
  // Makes the event loop close a watched descriptor.  The descriptor's handler is not called any
  // more.
  virtual void Forget(Watched watched) = 0;
};

// Type and name of the function in libopenr_panel.so that makes the event loop.  `protocol` is the
// WebSocket subprotocol of pages.  Returns null if libwebsockets cannot be started.
using MakeWebLoop = WebLoop*(WebService* service, const char* protocol);
constexpr char kMakeWebLoopName[] = "openr_make_web_loop";

}  // namespace openr_host
