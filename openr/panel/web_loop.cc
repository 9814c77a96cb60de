#include "openr/panel/web_loop.h"

#include <libwebsockets.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace openr_host {
namespace {

// Size in bytes of the socket's buffer for a page; the kernel doubles it.  The size is small
// because newer values cannot replace the values in this buffer, and a slow page should get fewer
// poses instead of late poses.
constexpr int kSendBufferSize = 128 << 10;
constexpr size_t kReceivePartMax = size_t{64} << 10;
constexpr size_t kHeadersMax = size_t{8} << 10;
constexpr unsigned kDescriptorsMax = 512;
// The largest number of bytes of a request's path and headers that libwebsockets keeps.  It closes
// the connection of a longer request without an answer.  The number is far above the longest path
// that the panel looks up (panel.cc), so that most requests with a longer path are answered.
constexpr unsigned short kRequestHeadersMax = 16 << 10;

// Shortens `why`, a reason for closing a WebSocket, to 123 bytes, the most that RFC 6455, section
// 5.5, allows.  Cuts between two characters of UTF-8, because a browser takes a part of a character
// for an error of the connection, and its page then gets another code than the server has sent.
std::string CloseReason(const std::string& why) {
  size_t size = std::min<size_t>(why.size(), 123);
  const auto continues_character = [&why](size_t i) { return (why[i] & 0xc0) == 0x80; };
  while (size > 0 && size < why.size() && continues_character(size)) --size;
  return why.substr(0, size);
}

class LwsConnection : public WebConnection {
 public:
  explicit LwsConnection(lws* wsi) : wsi_(wsi) {}

  void WantWrite() override { lws_callback_on_writable(wsi_); }
  void CloseWhenSent(int code, const std::string& why) override {
    if (!close_code_) close_code_ = code;
    close_why_ = why;
    WantWrite();
  }
  void Abort() override {
    lws_set_timeout(wsi_, PENDING_TIMEOUT_KILLED_BY_PARENT, LWS_TO_KILL_ASYNC);
  }
  void SetReading(bool is_on) override {
    // Begins or stops reading from the page at once (PROCESS_NOW).  Without PROCESS_NOW,
    // libwebsockets may do so only in the next callback of this connection.  This callback may
    // never come: reading is switched on in a callback of another connection, when the run has
    // taken requests, and the page may then wait for the answer to a request that was not read yet.
    constexpr int kOn = LWS_RXFLOW_REASON_USER_BOOL | LWS_RXFLOW_REASON_APPLIES_ENABLE |
                        LWS_RXFLOW_REASON_FLAG_PROCESS_NOW;
    lws_rx_flow_control(wsi_, is_on ? kOn : 0);
  }

  // Sends the next message to the page.  Returns the result for libwebsockets' callback: not 0 if
  // the connection must be closed.
  int Send(WebPage* page) {
    const std::string text = page->Next();
    if (!text.empty()) {
      buffer_.resize(LWS_PRE + text.size());
      std::memcpy(buffer_.data() + LWS_PRE, text.data(), text.size());
      if (lws_write(wsi_, buffer_.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT) < 0) return -1;
      WantWrite();
      return 0;
    }
    if (!close_code_) return 0;
    std::string why = CloseReason(close_why_);
    lws_close_reason(wsi_, static_cast<lws_close_status>(*close_code_),
                     reinterpret_cast<unsigned char*>(why.data()), why.size());
    return -1;
  }

 private:
  lws* const wsi_;
  std::vector<unsigned char> buffer_;
  std::optional<int> close_code_;
  std::string close_why_;
};

// The data that libwebsockets keeps for one WebSocket.
struct Session {
  explicit Session(lws* wsi) : connection(wsi) {}
  LwsConnection connection;
  std::unique_ptr<WebPage> page;
};

std::string HeaderOf(lws* wsi, lws_token_indexes token) {
  const int length = lws_hdr_total_length(wsi, token);
  std::string value(static_cast<size_t>(std::max(length, 0)) + 1, '\0');
  const int copied = lws_hdr_copy(wsi, value.data(), static_cast<int>(value.size()), token);
  value.resize(static_cast<size_t>(std::max(copied, 0)));
  return value;
}

std::string ArgumentOf(lws* wsi, std::string_view name) {
  char text[256];
  for (int i = 0; lws_hdr_copy_fragment(wsi, text, sizeof text, WSI_TOKEN_HTTP_URI_ARGS, i) > 0;
       ++i) {
    const std::string_view argument = text;
    if (argument.starts_with(name)) return std::string(argument.substr(name.size()));
  }
  return "";
}

WebRequest RequestOf(lws* wsi) {
  WebRequest request;
  request.path = HeaderOf(wsi, WSI_TOKEN_GET_URI);
  request.is_get = !request.path.empty();
  request.host = HeaderOf(wsi, WSI_TOKEN_HOST);
  request.origin = HeaderOf(wsi, WSI_TOKEN_ORIGIN);
  request.protocol = HeaderOf(wsi, WSI_TOKEN_PROTOCOL);
  request.run = ArgumentOf(wsi, "run=");
  return request;
}

// Adds the headers of `answer` at `*at`, and moves `*at` behind them.  Returns false if there is no
// room for the headers.
bool AddHeaders(lws* wsi, const WebAnswer& answer, unsigned char** at, unsigned char* end) {
  const auto add = [&](const std::string& title, std::string_view value) {
    return lws_add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(title.c_str()),
                                       reinterpret_cast<const unsigned char*>(value.data()),
                                       static_cast<int>(value.size()), at, end) == 0;
  };
  for (const auto& [name, value] : answer.headers) {
    if (!add(name + ":", value)) return false;
  }
  return add("connection:", "close");
}

// Sends the answer to an HTTP request; its bytes are in answer.text.  Sends nothing if the headers
// are too long.
void SendText(lws* wsi, const WebAnswer& answer) {
  std::array<unsigned char, LWS_PRE + kHeadersMax> headers;
  unsigned char* const begin = headers.data() + LWS_PRE;
  unsigned char* at = begin;
  unsigned char* const end = headers.data() + headers.size() - 1;
  if (lws_add_http_common_headers(wsi, static_cast<unsigned>(answer.status), answer.type.c_str(),
                                  answer.text.size(), &at, end) != 0 ||
      !AddHeaders(wsi, answer, &at, end) ||
      lws_finalize_write_http_header(wsi, begin, &at, end) != 0)
    return;
  std::vector<unsigned char> body(LWS_PRE + answer.text.size());
  std::memcpy(body.data() + LWS_PRE, answer.text.data(), answer.text.size());
  // Ignores an error, because the connection is closed next, with or without an error.
  lws_write(wsi, body.data() + LWS_PRE, answer.text.size(), LWS_WRITE_HTTP_FINAL);
}

// Sends `answer` to an HTTP request.  Returns the result for libwebsockets' callback: not 0 if
// libwebsockets must close the connection, which it does after it has sent the answer.
//
// Every answer ends its connection, because libwebsockets 4.1 never finishes parsing some requests
// that come in the same packet behind another request.  With such requests, one client could stop
// the panel for all others.
int SendAnswer(lws* wsi, const WebAnswer& answer) {
  if (answer.file.empty()) {
    SendText(wsi, answer);
    return -1;
  }
  std::array<unsigned char, kHeadersMax> headers;
  unsigned char* at = headers.data();
  if (!AddHeaders(wsi, answer, &at, headers.data() + headers.size())) return -1;
  const int result = lws_serve_http_file(wsi, answer.file.c_str(), answer.type.c_str(),
                                         reinterpret_cast<const char*>(headers.data()),
                                         static_cast<int>(at - headers.data()));
  return result == 0 ? 0 : -1;  // 0: the file is being sent
}

class LwsLoop : public WebLoop {
 public:
  LwsLoop(WebService* service, const char* protocol) : service_(service), protocol_(protocol) {
    lws_set_log_level(LLL_ERR, nullptr);
    protocols_[0].name = "http";
    protocols_[0].callback = &OnHttp;
    protocols_[1].name = protocol_.c_str();
    protocols_[1].callback = &OnPage;
    protocols_[1].per_session_data_size = sizeof(Session*);
    protocols_[1].rx_buffer_size = kReceivePartMax;
    protocols_[2].name = kDescriptorProtocol;
    protocols_[2].callback = &OnDescriptor;
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.protocols = protocols_.data();
    info.user = this;
    info.fd_limit_per_thread = kDescriptorsMax;
    info.max_http_header_data = kRequestHeadersMax;
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    context_ = lws_create_context(&info);
    if (context_ != nullptr) vhost_ = lws_create_vhost(context_, &info);
  }
  ~LwsLoop() override {
    if (context_ != nullptr) lws_context_destroy(context_);
  }
  bool is_good() const { return vhost_ != nullptr; }

  void Run() override {
    while (!is_stopped_ && lws_service(context_, 0) >= 0) {
    }
  }
  void Stop() override {
    is_stopped_ = true;
    lws_cancel_service(context_);
  }
  void StopAfter(int ms) override {
    lws_sul_schedule(context_, 0, &stop_timer_.timer, &OnStopTimer,
                     static_cast<lws_usec_t>(ms) * LWS_US_PER_MS);
  }
  void Wake() override { lws_cancel_service(context_); }

  void Serve(int connection) override {
    setsockopt(connection, SOL_SOCKET, SO_SNDBUF, &kSendBufferSize, sizeof kSendBufferSize);
    // Does not test the result, because lws_adopt_socket_vhost() closes the descriptor itself when
    // it fails.
    lws_adopt_socket_vhost(vhost_, connection);
  }

  Watched Watch(int descriptor, WebDescriptor* handler) override {
    lws_sock_file_fd_type file{};
    file.filefd = descriptor;
    lws* const wsi = lws_adopt_descriptor_vhost(vhost_, LWS_ADOPT_RAW_FILE_DESC, file,
                                                kDescriptorProtocol, nullptr);
    if (wsi != nullptr) lws_set_opaque_user_data(wsi, handler);
    return wsi;
  }
  void WantWrite(Watched watched) override {
    lws* const wsi = static_cast<lws*>(watched);
    if (wsi != writing_) {
      lws_callback_on_writable(wsi);
      return;
    }
    // Asks libwebsockets only later to report that `wsi` can be written, because libwebsockets
    // forgets such a request if it is made in the callback of the same descriptor.
    write_again_.push_back(wsi);
    Wake();
  }
  void Forget(Watched watched) override {
    lws* const wsi = static_cast<lws*>(watched);
    std::erase(write_again_, wsi);
    lws_set_opaque_user_data(wsi, nullptr);
    lws_set_timeout(wsi, PENDING_TIMEOUT_KILLED_BY_PARENT, LWS_TO_KILL_ASYNC);
  }

 private:
  static constexpr char kDescriptorProtocol[] = "openr-descriptor";

  static LwsLoop* LoopOf(lws* wsi) {
    return static_cast<LwsLoop*>(lws_context_user(lws_get_context(wsi)));
  }

  static void OnStopTimer(lws_sorted_usec_list_t* timer) {
    reinterpret_cast<StopTimer*>(timer)->loop->Stop();
  }

  static int OnHttp(lws* wsi, lws_callback_reasons reason, void* user, void* in, size_t size) {
    switch (reason) {
      case LWS_CALLBACK_HTTP:
        return SendAnswer(wsi, LoopOf(wsi)->service_->Answer(RequestOf(wsi)));
      case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE: {
        // Refuses all upgrades except those to WebSockets, because requests after an upgrade to
        // HTTP/2 would avoid the checks of service_.
        if (std::strcmp(static_cast<const char*>(in), "websocket") != 0) return -1;
        const auto refusal = LoopOf(wsi)->service_->Refuse(RequestOf(wsi));
        if (refusal == nullptr) return 0;
        SendText(wsi, *refusal);
        return -1;
      }
      case LWS_CALLBACK_HTTP_FILE_COMPLETION:
        return -1;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        LoopOf(wsi)->AskToWriteAgain();
        LoopOf(wsi)->service_->OnWake();
        return 0;
      default:
        return lws_callback_http_dummy(wsi, reason, user, in, size);
    }
  }

  static int OnPage(lws* wsi, lws_callback_reasons reason, void* user, void* in, size_t size) {
    Session** const session = static_cast<Session**>(user);
    switch (reason) {
      case LWS_CALLBACK_ESTABLISHED:
        *session = new Session(wsi);
        (*session)->page = LoopOf(wsi)->service_->Open(RequestOf(wsi), &(*session)->connection);
        return 0;
      case LWS_CALLBACK_RECEIVE:
        (*session)->page->ReceivePart({static_cast<const char*>(in), size},
                                      lws_frame_is_binary(wsi) == 0,
                                      lws_is_final_fragment(wsi) != 0);
        return 0;
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return (*session)->connection.Send((*session)->page.get());
      case LWS_CALLBACK_CLOSED:
        delete *session;
        *session = nullptr;
        return 0;
      default:
        return 0;
    }
  }

  // Lets `handler` write to the descriptor of `wsi`.  Returns false if the descriptor must be
  // closed.
  bool Write(lws* wsi, WebDescriptor* handler) {
    writing_ = wsi;
    const bool is_good = handler != nullptr && handler->OnWritable();
    writing_ = nullptr;
    return is_good;
  }

  void AskToWriteAgain() {
    for (lws* const wsi : std::exchange(write_again_, {})) lws_callback_on_writable(wsi);
  }

  static int OnDescriptor(lws* wsi, lws_callback_reasons reason, void*, void*, size_t) {
    auto* const handler = static_cast<WebDescriptor*>(lws_get_opaque_user_data(wsi));
    switch (reason) {
      case LWS_CALLBACK_RAW_RX_FILE:
        return handler != nullptr && handler->OnReadable() ? 0 : -1;
      case LWS_CALLBACK_RAW_WRITEABLE_FILE:
        return LoopOf(wsi)->Write(wsi, handler) ? 0 : -1;
      case LWS_CALLBACK_RAW_CLOSE_FILE:
        std::erase(LoopOf(wsi)->write_again_, wsi);
        lws_set_opaque_user_data(wsi, nullptr);
        if (handler != nullptr) handler->OnClosed();
        return 0;
      default:
        return 0;
    }
  }

  // The timer must be the first member, because its callback converts the address of the timer to
  // the address of the struct.
  struct StopTimer {
    lws_sorted_usec_list_t timer;
    LwsLoop* loop;
  };

  WebService* const service_;
  const std::string protocol_;
  std::array<lws_protocols, 4> protocols_{};  // the last element stays empty and ends the list
  lws_context* context_ = nullptr;
  lws_vhost* vhost_ = nullptr;
  StopTimer stop_timer_{{}, this};
  lws* writing_ = nullptr;         // the connection whose descriptor is written to now
  std::vector<lws*> write_again_;  // the connections whose descriptors have more to write
  bool is_stopped_ = false;
};

}  // namespace
}  // namespace openr_host

extern "C" __attribute__((visibility("default"))) openr_host::WebLoop* openr_make_web_loop(
    openr_host::WebService* service, const char* protocol) {
  auto loop = std::make_unique<openr_host::LwsLoop>(service, protocol);
  return loop->is_good() ? loop.release() : nullptr;
}
