// RunLink, the connection of one page to the socket of its run (openr/live).
#pragma once

#include <functional>
#include <string>

#include "openr/live/live_folder.h"
#include "openr/panel/web_loop.h"

namespace openr_host {

class RunLink final : public WebDescriptor {
 public:
  // The largest number of bytes of lines that may wait until the run takes them.  If more bytes
  // wait, the server should stop reading from the page.
  static constexpr size_t kWaitingMax = size_t{256} << 10;
  // The largest number of bytes that a line from the run may have.
  static constexpr size_t kLineMax = size_t{8} << 20;

  struct Owner {
    std::function<void(std::string line)> take_line;
    // A function that is called once when the connection to the run is lost.  The owner of this
    // RunLink may delete it in this function.
    std::function<void(const std::string& why)> end;
    // A function that is called when the number of bytes that wait for the run is no longer above
    // kWaitingMax, so that the page may send more lines.
    std::function<void()> resume;
  };

  // Begins to connect to the run, and does not wait.  Throws std::runtime_error if the connection
  // cannot be begun.
  RunLink(WebLoop* loop, const LiveRun& run, Owner owner);
  ~RunLink();
  RunLink(const RunLink&) = delete;
  RunLink& operator=(const RunLink&) = delete;

  // Sends a line to the run.  Returns false if the page should send no more lines until resume() is
  // called.
  bool Send(const std::string& line);
  // Passes on the lines that the run has sent and that were not read yet.  Called when the run has
  // ended, so that its last answers are not lost.
  void PassOnRest();

  bool OnReadable() override;
  bool OnWritable() override;
  void OnClosed() override;

 private:
  void PassOnLines();

  WebLoop* const loop_;
  const std::string name_;
  Owner owner_;
  WebLoop::Watched watched_ = nullptr;
  int descriptor_ = -1;   // descriptor of the socket, which the loop owns
  std::string received_;  // the first bytes of a line that is not complete yet
  std::string to_send_;
  bool has_answered_ = false;
};

}  // namespace openr_host
