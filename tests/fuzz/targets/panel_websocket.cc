// The fuzz target panel_websocket: messages of a page to the panel's server, in parts, as the
// WebSocket gives them.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/json_text.h"
#include "openr/panel/page.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

class NoLoop final : public WebLoop {
 public:
  void Run() override {}
  void Stop() override {}
  void StopAfter(int) override {}
  void Wake() override {}
  void Serve(int) override {}
  Watched Watch(int, WebDescriptor*) override { return nullptr; }
  void WantWrite(Watched) override {}
  void Forget(Watched) override {}
};

class Socket final : public WebConnection {
 public:
  void WantWrite() override { wants_write = true; }
  void CloseWhenSent(int code, const std::string& why) override {
    FuzzCheck(!is_over(), "a socket is closed once");
    FuzzCheck(!why.empty(), "a reason");
    close_code = code;
  }
  void Abort() override {
    FuzzCheck(!is_over(), "a socket is closed once");
    is_aborted = true;
  }
  void SetReading(bool) override {}
  bool is_over() const { return is_aborted || close_code != 0; }

  bool wants_write = false, is_aborted = false;
  int close_code = 0;
};

// Returns whether a request would make the server look for other runs, or connect to a robot.
// Such requests are left out, because their answers depend on the computer.
bool LeavesProcess(const std::string& text) {
  // Ignores JSON that is nested so deeply that the panel's server refuses it, too (TryParseJson()).
  const auto request = TryParseJson<nlohmann::json>(text);
  if (!request.is_object() || !request.contains("do")) return false;
  const nlohmann::json& what = request["do"];
  return what == "runs" || (what == "rc" && request.contains("endpoint"));
}

}  // namespace

// The input is a row of parts: a byte with flags, the size (two bytes), the bytes.
bool fuzz::panel_websocket(std::string_view bytes) {
  static RunsLister runs("");
  NoLoop loop;
  Socket socket;
  Page page(&loop, &socket, &runs, true);
  FuzzBytes input(bytes);
  std::string message;
  int parts = 0;
  bool has_found = false;
  while (!input.empty()) {
    BeginFuzzStep(input.taken());
    const uint8_t flags = input.U8();
    size_t size = input.U8();
    size += size_t{input.U8()} << 8;
    // Large messages are made of few bytes of the input.
    std::string part(input.Text(size));
    if ((flags & 0x10) != 0) part.append(size, ' ');
    message += part;
    parts += 1;
    const bool is_last = (flags & 1) != 0;
    if (is_last && LeavesProcess(message)) return false;
    page.ReceivePart(part, (flags & 0x0e) != 0x0e, is_last);
    if (is_last) message.clear();
    for (std::string answer = page.Next(); !answer.empty(); answer = page.Next()) {
      const nlohmann::json read = nlohmann::json::parse(answer, nullptr, false);
      FuzzCheck(read.is_object(), "an answer is a JSON object");
      const nlohmann::json id = read.value("id", nlohmann::json());
      has_found |= parts > 1 && id.is_number_unsigned() && id > 70 && read.contains("error");
    }
    if (is_last) parts = 0;
  }
  page.Leave();
  return has_found;
}

}  // namespace openr_host
