// Page, the server's end of one page that is open in a browser.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "openr/live/live_folder.h"
#include "openr/panel/outbox.h"
#include "openr/panel/page_queue.h"
#include "openr/panel/pair_bridge.h"
#include "openr/panel/rc_bridge.h"
#include "openr/panel/run_link.h"
#include "openr/panel/runs_lister.h"
#include "openr/panel/web_loop.h"

namespace openr_host {

// Codes with which the server closes the WebSocket of a page (docs/panel-server.md).  1003 to 1013
// are those of RFC 6455; 4000 and above are our own.
enum PageClose {
  kCloseNoText = 1003,
  kCloseTooLong = 1009,
  kCloseTooMany = 1013,
  kCloseRunEnded = 4001,
  kCloseNoRun = 4002,
};

class Page : public WebPage {
 public:
  // Bytes of a message of a page: of an upload, and of all others.
  static constexpr size_t kUploadMax = size_t{12} << 20;
  static constexpr size_t kMessageMax = size_t{64} << 10;
  // Bytes that the server drops of the message during which it ends a page.
  static constexpr size_t kDropMax = size_t{64} << 20;
  // Number of robots whose remote control one page uses at a time.
  static constexpr size_t kEndpointsMax = 4;

  Page(WebLoop* loop, WebConnection* connection, RunsLister* runs);
  ~Page() override;

  // Connects the page to a run.  The page is told if that is not possible.
  void Join(const LiveRun& run);

  // Tells the page that its run has ended, or why there is none, and closes it.  If the page is
  // amid a message, the connection is closed after that message: when a socket is closed with
  // unread bytes in it, the kernel of the other side throws away what it has received, so that the
  // page would not see why it was closed.
  void End(int code, const std::string& why);

  // Takes the answers of threads.
  void Collect();

  // Closes all connections.  Called before the loop ends, because the page lives longer.
  void Leave();

  void Take(std::string_view part, bool is_text, bool is_last) override;
  std::string Next() override;

 private:
  void Obey(const std::string& text);
  void PassOn(const std::string& text, const nlohmann::json& request);
  void CallRobot(nlohmann::json request, size_t size);
  void CallPair(const nlohmann::json& request);
  RcBridge* BridgeTo(const nlohmann::json& request);
  void Refuse(const nlohmann::json& request, const std::string& why);
  void Queue(std::string text);
  void Drop(size_t size, bool is_last);

  WebLoop* const loop_;
  WebConnection* const connection_;
  RunsLister* const runs_;
  const std::shared_ptr<Outbox> outbox_;
  std::optional<LiveRun> run_;
  std::unique_ptr<RunLink> link_;                             // null: no run
  std::map<std::string, std::unique_ptr<RcBridge>> bridges_;  // by endpoint
  std::map<size_t, std::unique_ptr<PairBridge>> pairs_;       // by robot of the run
  std::string received_;                                      // the begin of the next message
  PageQueue queue_;
  bool is_amid_message_ = false;  // a part of a message has come, but not its last part
  bool is_closing_ = false;       // nothing more is queued or obeyed
  // Code and reason of a close that waits for the end of the message that is coming.
  struct Ending {
    int code;
    std::string why;
  };
  std::optional<Ending> ending_;
  size_t dropped_ = 0;  // bytes of that message
};

}  // namespace openr_host
