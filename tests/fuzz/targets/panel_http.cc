// The fuzz target panel_http: bytes of a client to the port of the panel, which libwebsockets
// reads: requests of HTTP, and the begin and the frames of a WebSocket.
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

#ifdef OPENR_FUZZ_PANEL
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "openr/panel/access.h"
#include "openr/panel/static_files.h"
#include "openr/panel/web_loop.h"

extern "C" openr_host::WebLoop* openr_make_web_loop(openr_host::WebService* service,
                                                    const char* protocol);

namespace openr_host {
namespace {

constexpr size_t kPartMax = size_t{64} << 10;

// A service that answers requests as the panel does, without a run behind it.
class FuzzedService final : public WebService {
 public:
  WebAnswer Answer(const WebRequest& request) override {
    static const FuzzFile file("<!doctype html><title>page</title>\n");
    WebAnswer answer;
    answer.text = access_.FileRefusal(request);
    if (!answer.text.empty()) {
      answer.status = 403;
    } else if (!request.is_get) {
      answer.status = 405;
      answer.headers.emplace_back("allow", "GET");
    } else if (request.path == "/") {
      answer.file = file.path();
    } else {
      answer.status = 404;
    }
    answer.headers.emplace_back("cache-control", CacheControlOf(request.path));
    return answer;
  }

  std::unique_ptr<WebAnswer> Refuse(const WebRequest& request) override {
    const std::string why = access_.SocketRefusal(request);
    if (why.empty()) return nullptr;
    WebAnswer answer;
    answer.status = 403;
    answer.text = why;
    return std::make_unique<WebAnswer>(answer);
  }

  std::unique_ptr<WebPage> Open(const WebRequest& request, WebConnection* connection) override;
  void OnWake() override {}

  std::string protocol() const { return access_.protocol(); }
  void Find() { has_found_ = true; }
  bool has_found() const { return has_found_; }

 private:
  const Access access_{"0123456789abcdef0123456789abcdef", "127.0.0.1", 8210};
  bool has_found_ = false;
};

// A page that sends each text back, and ends its WebSocket when bytes come that are no text.
class EchoPage final : public WebPage {
 public:
  EchoPage(FuzzedService* service, WebConnection* connection)
      : service_(service), connection_(connection) {}

  void ReceivePart(std::string_view part, bool is_text, bool is_last) override {
    FuzzCheck(part.size() <= kPartMax, "a part is not larger than the server's buffer");
    message_ += part;
    parts_ += part.empty() ? 0 : 1;
    if (!is_text) connection_->CloseWhenSent(1003, "only text is read");
    if (!is_last) return;
    // All counts of parts have the same branches.
    ReachFuzzState(static_cast<uint64_t>(std::min(parts_, 9)));
    if (parts_ > 3) service_->Find();
    if (!message_.empty()) waiting_.push_back(message_);
    message_.clear();
    parts_ = 0;
    connection_->WantWrite();
  }

  std::string Next() override {
    if (waiting_.empty()) return "";
    const std::string text = waiting_.front();
    waiting_.erase(waiting_.begin());
    return text;
  }

 private:
  FuzzedService* const service_;
  WebConnection* const connection_;
  std::string message_;
  int parts_ = 0;
  std::vector<std::string> waiting_;
};

std::unique_ptr<WebPage> FuzzedService::Open(const WebRequest& request, WebConnection* connection) {
  FuzzCheck(access_.SocketRefusal(request).empty(), "the WebSocket was not refused");
  return std::make_unique<EchoPage>(this, connection);
}

// The client's end of a connection.  Reads all answers, and stops the loop when the server has
// closed its end.
class FuzzedClient final : public WebDescriptor {
 public:
  FuzzedClient(int descriptor, WebLoop* loop) : descriptor_(descriptor), loop_(loop) {}

  bool OnReadable() override {
    char buffer[16 << 10];
    const ssize_t count = recv(descriptor_, buffer, sizeof buffer, 0);
    if (count > 0) {
      if (received_.size() < 5)
        received_.append(buffer, static_cast<size_t>(std::min<ssize_t>(count, 5)));
      FuzzCheck(received_.size() < 5 || received_.starts_with("HTTP/"), "an answer is HTTP");
      return true;
    }
    loop_->Stop();
    return false;
  }
  void OnClosed() override {}

 private:
  const int descriptor_;
  WebLoop* const loop_;
  std::string received_;  // the begin of what came
};

// Notes where the steps of an input begin: the lines of requests, and the frames of a WebSocket.
void NoteHttpSteps(std::string_view bytes) {
  FuzzBytes input(bytes);
  bool is_upgrade = false, is_frames = false;
  while (!input.empty()) {
    BeginFuzzStep(input.taken());
    const std::string_view rest = bytes.substr(input.taken());
    if (is_frames) {
      constexpr size_t kMask = 4;
      const size_t size = rest.size() > 1 ? static_cast<uint8_t>(rest[1]) & 0x7f : 0;
      input.Text(2 + kMask + size);
      continue;
    }
    const std::string_view line = input.Text(std::min(rest.find('\n'), rest.size() - 1) + 1);
    is_upgrade |= line.starts_with("Upgrade:");
    is_frames = is_upgrade && line == "\r\n";
  }
}

}  // namespace

bool fuzz::panel_http(std::string_view bytes) {
  NoteHttpSteps(bytes);
  FuzzedService service;
  int ends[2];
  FuzzCheck(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) == 0,
            "a connection");
  const std::unique_ptr<WebLoop> loop(openr_make_web_loop(&service, service.protocol().c_str()));
  FuzzCheck(loop != nullptr, "a loop");
  FuzzCheck(
      send(ends[0], bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size()),
      "the bytes are sent");
  // The server closes its end when it has read all bytes, because no more can come.
  shutdown(ends[0], SHUT_WR);
  FuzzedClient client(ends[0], loop.get());
  FuzzCheck(loop->Watch(ends[0], &client) != nullptr, "the client");
  loop->Serve(ends[1]);
  loop->Run();
  return service.has_found();
}

}  // namespace openr_host

#else  // This build has no panel, because libwebsockets is missing.
bool openr_host::fuzz::panel_http(std::string_view) { return false; }
#endif
