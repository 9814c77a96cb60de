// Page, the server's end of one page that is open in a browser.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "openr/live/live_folder.h"
#include "openr/panel/answer_queue.h"
#include "openr/panel/page_queue.h"
#include "openr/panel/pair_bridge.h"
#include "openr/panel/rc_bridge.h"
#include "openr/panel/run_link.h"
#include "openr/panel/runs_lister.h"
#include "openr/panel/web_loop.h"

namespace openr_host {

// Codes with which the server closes the WebSocket of a page (docs/panel-server.md).  Codes 1003 to
// 1013 are from RFC 6455; codes from 4000 on are our own.
enum PageClose {
  kCloseNoText = 1003,
  kCloseTooLong = 1009,
  kCloseTooMany = 1013,
  kCloseRunEnded = 4001,
  kCloseNoRun = 4002,
};

class Page : public WebPage {
 public:
  // The largest number of bytes of an upload, which is one message of a page.
  static constexpr size_t kUploadMax = size_t{12} << 20;
  // The largest number of bytes of a message, other than an upload, that a page sends.
  static constexpr size_t kMessageMax = size_t{64} << 10;
  // The largest number of bytes that the server reads and drops after it has decided to close a
  // page.
  static constexpr size_t kDropMax = size_t{64} << 20;
  // The largest number of robots whose remote control one page may use at a time.
  static constexpr size_t kEndpointsMax = 4;

  // Makes the server's end of a page.  `allows_controllers` says whether the page may upload
  // controllers.
  Page(WebLoop* loop, WebConnection* connection, RunsLister* runs, bool allows_controllers);
  ~Page() override;

  // Connects the page to the run `run`.  If that is not possible, tells the page why.
  void Join(const LiveRun& run);

  // Passes the last answers of the run on to the page.  Called when the run has ended.
  void PassOnLastAnswers();
  // Tells the page that its run has ended, or why it has no run, and closes the page.  If a part of
  // a message from the page has come, first waits for the rest of this message.  If the server
  // closed a socket with unread bytes, the kernel on the page's side would throw away what it has
  // received, and the page would not see the reason.
  void End(int code, const std::string& why);

  // Sends to the page the answers that threads have put into the queue of texts for it.
  void Collect();

  // Closes all connections of the page.  Called before the event loop of the server ends, because
  // the page is destroyed only after the loop.
  void Leave();

  void ReceivePart(std::string_view part, bool is_text, bool is_last) override;
  std::string Next() override;

 private:
  void HandleRequest(const std::string& text);
  void PassOn(const std::string& text, const nlohmann::json& id);
  void CallRobot(nlohmann::json request, size_t size);
  void CallPair(const nlohmann::json& request);
  RcBridge* BridgeTo(const nlohmann::json& request);
  void Refuse(const nlohmann::json& id, const std::string& why);
  void Queue(std::string text);
  void Drop(size_t size, bool is_last);

  WebLoop* const loop_;
  WebConnection* const connection_;
  RunsLister* const runs_;
  const bool allows_controllers_;
  const std::shared_ptr<AnswerQueue> answers_;
  std::optional<LiveRun> run_;
  std::unique_ptr<RunLink> link_;  // the connection to the run; null: the page has no run
  // The robots whose remote control the page uses.  The key is "HOST:PORT", or "run N" for robot N
  // of the run.
  std::map<std::string, std::unique_ptr<RcBridge>> bridges_;
  // The bridges that connect robots of the run with second robots.  The key is the number of the
  // robot of the run.
  std::map<size_t, std::unique_ptr<PairBridge>> pairs_;
  // The first bytes of a message from the page that is not complete yet.
  std::string received_;
  PageQueue queue_;
  bool is_amid_message_ = false;  // true: a part of a message has come, but not its last part
  bool is_closing_ = false;       // true: further messages to or from the page are dropped
  // The code and the reason with which the server closes the page when the rest of the present
  // message from the page has come.
  struct Ending {
    int code;
    std::string why;
  };
  std::optional<Ending> ending_;
  size_t dropped_ = 0;  // number of bytes that were dropped of the present message from the page
};

}  // namespace openr_host
