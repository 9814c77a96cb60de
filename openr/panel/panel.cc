#include "openr/panel/panel.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cstring>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "cli/install_paths.h"
#include "cli/standard_streams.h"
#include "openr/live/live_folder.h"
#include "openr/panel/access.h"
#include "openr/panel/endpoints.h"
#include "openr/panel/listen.h"
#include "openr/panel/page.h"
#include "openr/panel/rc_forwarder.h"
#include "openr/panel/runs_lister.h"
#include "openr/panel/spare_descriptor.h"
#include "openr/panel/static_files.h"
#include "openr/panel/web_loop.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

constexpr size_t kPagesMax = 16;
// Longest path of a file that is looked up; the paths of the page's files are far shorter.
constexpr size_t kPathMax = 2048;
// The time that the server of the panel waits before it ends, so that pages can receive the message
// that the run has ended.
constexpr int kFarewellMs = 300;
// The time that the server waits if it can neither accept nor close a connection, so that it does
// not try again without a pause.
constexpr int kNoDescriptorMs = 10;

constexpr char kNoPage[] =
    R"(<!doctype html><html lang="en"><meta charset="utf-8"><title>openr panel</title>
<h1>The page of the panel is not built</h1>
<p>This openr was built without node and npm (Debian packages nodejs and npm). Install them, then
configure and build again: <code>./dev build</code>, or <code>cmake --build BUILD --target
panel_page</code>.</p>
<p>All else works: <code>openr poke</code>, <code>openr attach</code> and <code>openr rc</code> act
on a run.</p></html>
)";

// Returns the run that `wanted` names by NAME.PROCESS, by its name or by its process id.  If
// `wanted` is "", returns the only run that goes on, or nullopt if several runs or none go on.
std::optional<LiveRun> FindRun(const std::string& wanted) {
  const std::vector<LiveRun> runs = LiveRuns();
  if (wanted.empty()) return runs.size() == 1 ? std::optional(runs[0]) : std::nullopt;
  for (const LiveRun& run : runs) {
    if (std::filesystem::path(run.socket).filename() == wanted) return run;
  }
  return FindLiveRun(wanted);
}

// Returns NAME.PROCESS of the run that pages show first; "" if pages let the user choose a run.
std::string FirstRun(const PanelOptions& options) {
  // Does not look up the name NAME.PROCESS, which a run gives to its server, because a short run
  // may have ended already, and that is no error.
  if (options.run_pipe >= 0) return options.run;
  const std::optional<LiveRun> run = FindRun(options.run);
  return run ? std::filesystem::path(run->socket).filename().string() : "";
}

std::string AddressOf(const ListenOptions& listen) {
  return listen.is_on() ? listen.address : "127.0.0.1";
}

// A descriptor that calls a function when it can be read, and is closed when the function returns
// false.
class Listener final : public WebDescriptor {
 public:
  explicit Listener(
      std::function<bool()> on_readable, std::function<void()> on_closed = [] {})
      : on_readable_(std::move(on_readable)), on_closed_(std::move(on_closed)) {}
  bool OnReadable() override { return on_readable_(); }
  void OnClosed() override { on_closed_(); }

 private:
  const std::function<bool()> on_readable_;
  const std::function<void()> on_closed_;
};

// Loads the library libopenr_panel.so and returns the event loop that it makes.
std::unique_ptr<WebLoop> LoadLoop(WebService* service, const std::string& protocol) {
  const std::string library = PanelLibrary();
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(
        fmt::format("no panel: {}; it needs libwebsockets (Debian package libwebsockets-dev): "
                    "install it, then configure and build openr again",
                    dlerror()));
  }
  auto* const make = reinterpret_cast<MakeWebLoop*>(dlsym(handle, kMakeWebLoopName));
  if (make == nullptr)
    throw std::runtime_error(fmt::format("{}: is of another version; build it again", library));
  std::unique_ptr<WebLoop> loop(make(service, protocol.c_str()));
  if (loop == nullptr) throw std::runtime_error("libwebsockets cannot be started");
  return loop;
}

class Panel : public WebService {
 public:
  explicit Panel(const PanelOptions& options);
  ~Panel();

  // Returns the lines that tell the user at which addresses the panel and the remote controls can
  // be reached.
  std::string Announcement() const;
  void Run() { loop_->Run(); }

  WebAnswer Answer(const WebRequest& request) override;
  std::unique_ptr<WebAnswer> Refuse(const WebRequest& request) override;
  std::unique_ptr<WebPage> Open(const WebRequest& request, WebConnection* connection) override;
  void OnWake() override;

 private:
  // A page that removes itself from the set of pages when its WebSocket is closed.
  class OpenPage;

  WebAnswer WithHeaders(WebAnswer answer, const std::string& host) const;
  void Watch(int descriptor, WebDescriptor* listener);
  void ForwardRemoteControl(int robot);
  void WatchSignals();
  void WatchRun(int run_pipe);
  void EndPages();

  const ListenOptions listen_;
  bool is_leaving_ = false;
  uint16_t port_;
  const int listener_descriptor_;
  const Access access_;
  const std::string folder_;  // folder of the built page; "": the page is not built
  std::string own_run_;
  RunsLister runs_;
  std::set<OpenPage*> pages_;
  int signals_ = -1;
  SpareDescriptor spare_{[] { poll(nullptr, 0, kNoDescriptorMs); }};
  Listener listener_, signal_listener_, run_listener_;
  // The remote control of one robot, which is forwarded to other computers (--listen).
  struct ForwardedRobot {
    uint16_t port;
    RcForwarder forwarder;
    Listener listener;
  };
  // A deque, because its elements stay where they are: loop_ keeps the addresses of the listeners.
  std::deque<ForwardedRobot> forwarded_;
  std::unique_ptr<WebLoop> loop_;
};

class Panel::OpenPage : public Page {
 public:
  OpenPage(Panel* panel, WebConnection* connection)
      : Page(panel->loop_.get(), connection, &panel->runs_,
             !panel->listen_.is_on() || panel->listen_.allows_controllers),
        panel_(panel) {
    panel_->pages_.insert(this);
  }
  ~OpenPage() override { panel_->pages_.erase(this); }

 private:
  Panel* const panel_;
};

Panel::Panel(const PanelOptions& options)
    : listen_(options.listen),
      port_(options.port),
      listener_descriptor_(Listen(AddressOf(listen_), &port_)),
      access_(listen_.is_on() ? ReadOrMakeToken(listen_.token_file) : NewToken(),
              AddressOf(listen_), port_),
      folder_(PanelFolder()),
      own_run_(FirstRun(options)),
      runs_(own_run_),
      listener_([this] {
        return AcceptAll(listener_descriptor_, &spare_,
                         [this](int client) { loop_->Serve(client); });
      }),
      signal_listener_([this] {
        loop_->Stop();
        return false;
      }),
      run_listener_([] { return false; }, [this] { EndPages(); }),
      loop_(LoadLoop(this, access_.protocol())) {
  Watch(listener_descriptor_, &listener_);
  for (int robot = 0; listen_.is_on() && robot < options.robots; ++robot)
    ForwardRemoteControl(robot);
  WatchSignals();
  if (options.run_pipe >= 0) loop_->Watch(options.run_pipe, &run_listener_);
}

Panel::~Panel() {
  is_leaving_ = true;
  for (OpenPage* const page : pages_) page->Leave();
}

void Panel::WatchSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  // Blocks the signals before any thread is made.  Each new thread inherits the blocked signals, so
  // they interrupt no thread; the event loop reads them from the descriptor signals_.
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  signals_ = signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
  if (signals_ >= 0) loop_->Watch(signals_, &signal_listener_);
}

void Panel::Watch(int descriptor, WebDescriptor* listener) {
  if (loop_->Watch(descriptor, listener) == nullptr)
    throw std::runtime_error("libwebsockets cannot watch the port");
}

// Opens a port for the remote control of the robot number `robot` of the run.
void Panel::ForwardRemoteControl(int robot) {
  uint16_t port =
      forwarded_.empty() ? listen_.rc_port : static_cast<uint16_t>(forwarded_.back().port + 1);
  const int descriptor = Listen(listen_.address, &port);
  struct LastAddress {
    std::mutex mutex;
    std::optional<remote::Address> address;
  };
  const auto find = [own_run = own_run_, robot, last = std::make_shared<LastAddress>()] {
    std::optional<LiveRun> run;
    try {
      run = FindRun(own_run);
    } catch (const std::runtime_error&) {
      // Uses the address of the robot's remote control that was found last.  After "Go on from
      // here" the run is another process, so it cannot be found by its old name; but it has the
      // same ports.
      const std::lock_guard lock(last->mutex);
      if (last->address) return *last->address;
      throw;
    }
    if (!run) throw std::runtime_error("there is no run, or several: openr panel --run names one");
    const remote::Address address = AddressInRun(*run, static_cast<size_t>(robot));
    const std::lock_guard lock(last->mutex);
    last->address = address;
    return address;
  };
  const size_t index = forwarded_.size();
  const auto accept = [this, descriptor, index] {
    return AcceptAll(descriptor, &spare_, [this, index](int client) {
      forwarded_[index].forwarder.ServeClient(client);
    });
  };
  forwarded_.push_back(
      {port, RcForwarder(find, access_.token(), listen_.allows_controllers), Listener(accept)});
  Watch(descriptor, &forwarded_.back().listener);
}

std::string Panel::Announcement() const {
  if (!listen_.is_on()) return fmt::format("panel: {}\n", access_.Url(access_.token()));
  // Names the file with the token, the secret that clients must send, and not the token itself,
  // because the output may go into a log.
  std::string text = fmt::format("panel: {}, where TOKEN is the first line of {}\n",
                                 access_.Url("TOKEN"), listen_.token_file);
  for (size_t i = 0; i < forwarded_.size(); ++i) {
    text += fmt::format("remote control{}: openr rc {}:{} --token-file {} info\n",
                        forwarded_.size() == 1 ? "" : fmt::format(" of robot {}", i),
                        listen_.address == kAnyAddress ? "ADDRESS" : listen_.address,
                        forwarded_[i].port, listen_.token_file);
  }
  return text +
         fmt::format(
             "other computers reach both at {}, with a copy of that file; nothing is encrypted; "
             "{}\n",
             listen_.address == kAnyAddress ? "all addresses of this computer" : listen_.address,
             listen_.allows_controllers
                 ? "they may upload controllers, which run as code of this user"
                 : "uploads of controllers are off (--allow-uploads)");
}

void Panel::EndPages() {
  if (is_leaving_) return;
  for (OpenPage* const page : pages_) {
    // Passes on the answers that the run sent shortly before its end, because the event loop may
    // see the end of the run first.
    page->PassOnLastAnswers();
    page->End(kCloseRunEnded, "the run has ended");
  }
  loop_->StopAfter(pages_.empty() ? 1 : kFarewellMs);
}

WebAnswer Panel::WithHeaders(WebAnswer answer, const std::string& host) const {
  const auto add = [&answer](const char* name, const std::string& value) {
    answer.headers.emplace_back(name, value);
  };
  // Allows data: and blob: for pictures, because pages make pictures and plots themselves.  Allows
  // inline styles, because pages set styles of elements.
  add("content-security-policy",
      fmt::format("default-src 'self'; connect-src 'self' {}; "
                  "img-src 'self' data: blob:; font-src 'self' data:; worker-src 'self' blob:; "
                  "style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; "
                  "form-action 'none'; frame-ancestors 'none'",
                  access_.SocketSource(host)));
  add("x-content-type-options", "nosniff");
  // Forbids the browser to send the address of the page to other sites, because the address has the
  // token, the secret that clients must send.
  add("referrer-policy", "no-referrer");
  add("cross-origin-opener-policy", "same-origin");
  add("cross-origin-resource-policy", "same-origin");
  return answer;
}

WebAnswer Panel::Answer(const WebRequest& request) {
  WebAnswer answer;
  if (const std::string why = access_.FileRefusal(request); !why.empty()) {
    answer.status = 403;
    answer.text = why + "\n";
  } else if (!request.is_get) {
    answer.status = 405;
    answer.text = "only GET is served\n";
    answer.headers.emplace_back("allow", "GET");
  } else if (request.path.size() > kPathMax) {
    answer.status = 414;
    answer.text = fmt::format("the path has more than {} bytes\n", kPathMax);
  } else if (folder_.empty() && request.path == "/") {
    answer.type = "text/html; charset=utf-8";
    answer.text = kNoPage;
  } else if (answer.file = FindStaticFile(folder_, request.path); answer.file.empty()) {
    answer.status = 404;
    answer.text = "there is no such file\n";
  } else {
    answer.type = ContentTypeOf(answer.file);
  }
  answer.headers.emplace_back("cache-control",
                              answer.status == 200 ? CacheControlOf(request.path) : "no-store");
  return WithHeaders(std::move(answer), request.host);
}

std::unique_ptr<WebAnswer> Panel::Refuse(const WebRequest& request) {
  WebAnswer answer;
  answer.status = 403;
  answer.text = access_.SocketRefusal(request);
  if (answer.text.empty() && request.path != "/ws") {
    answer.status = 404;
    answer.text = "WebSockets are at /ws";
  }
  if (answer.text.empty()) return nullptr;
  answer.text += '\n';
  return std::make_unique<WebAnswer>(WithHeaders(std::move(answer), request.host));
}

std::unique_ptr<WebPage> Panel::Open(const WebRequest& request, WebConnection* connection) {
  // Compares the number of pages with the limit before OpenPage() adds the new page to pages_, so
  // that kPagesMax pages can be open.
  const bool is_full = pages_.size() >= kPagesMax;
  auto page = std::make_unique<OpenPage>(this, connection);
  if (is_full) {
    page->End(kCloseTooMany, fmt::format("{} pages are open already; close one", kPagesMax));
    return page;
  }
  try {
    const std::optional<LiveRun> run = FindRun(request.run.empty() ? own_run_ : request.run);
    if (run) page->Join(*run);
  } catch (const std::exception& error) {
    page->End(kCloseNoRun, error.what());
  }
  return page;
}

void Panel::OnWake() {
  for (OpenPage* const page : pages_) page->Collect();
}

// Returns whether the run that holds the other end of the pipe `run_pipe` has ended.
bool HasRunEnded(int run_pipe) {
  // Asks for no event, because poll() always reports that the other end is closed.
  pollfd wanted = {run_pipe, 0, 0};
  return poll(&wanted, 1, 0) > 0;
}

// Prints the addresses at which the server of the panel can be reached.  A server that a run has
// started prints this text on standard error, like all messages of a run to the user.  Uses one
// write(), so that text of the run does not come in between.
void Print(const std::string& announcement, bool is_of_run) {
  if (!is_of_run) {
    PrintAnswer(TerminalText(announcement));
    FlushAnswer();
    return;
  }
  std::string text;
  std::istringstream lines(announcement);
  for (std::string line; std::getline(lines, line);) text += "openr: " + TerminalText(line) + "\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
  // Makes standard error of the server of the panel lead to /dev/null.  A program that reads the
  // output of the run waits until all processes have closed this output, and the server must not
  // keep it waiting.
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

}  // namespace

void ServePanel(const PanelOptions& options) {
  {
    Panel panel(options);
    // Prints nothing if the run has ended already, because the last line of a run must be the
    // reason for its end.
    if (options.run_pipe >= 0 && HasRunEnded(options.run_pipe)) return;
    Print(panel.Announcement(), options.run_pipe >= 0);
    panel.Run();
  }
  if (!RcBridge::HasThreads() && !PairBridge::HasThreads() && !RunsLister::HasThreads() &&
      !RcForwarder::HasThreads())
    return;
  // Ends the process without destructors of static variables, because a thread of the panel still
  // waits for a robot and may use these variables.
  const int exit_code = FinishStandardOutput(0, "openr");
  fflush(nullptr);
  _exit(exit_code);
}

}  // namespace openr_host
