#include "openr/panel/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/json_text.h"
#include "openr/live/request_reader.h"
#include "openr/panel/endpoints.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Returns whether `text`, the first part of a message from a page, shows that the message is an
// upload.
bool BeginsUpload(std::string_view text) {
  return text.substr(0, Page::kMessageMax).find("\"upload\"") != std::string_view::npos;
}

bool IsUpload(const nlohmann::json& request) {
  const JsonReader reader = RequestReader(request);
  return reader.TextOr("do", "") == "rc" && reader.TextOr("call", "") == "upload";
}

// Returns the number of the robot of the run that `request` is about.
size_t RobotOf(const nlohmann::json& request) {
  const int64_t robot = RequestReader(request).WholeOr("robot", INT64_MIN, INT64_MAX, 0);
  if (robot < 0) throw std::runtime_error(fmt::format("there is no robot {}", robot));
  return static_cast<size_t>(robot);
}

}  // namespace

Page::Page(WebLoop* loop, WebConnection* connection, RunsLister* runs, bool allows_controllers)
    : loop_(loop),
      connection_(connection),
      runs_(runs),
      allows_controllers_(allows_controllers),
      answers_(std::make_shared<AnswerQueue>([loop] { loop->Wake(); })) {}

Page::~Page() { Leave(); }

void Page::Leave() {
  answers_->Close();
  bridges_.clear();
  pairs_.clear();
  link_.reset();
}

void Page::Join(const LiveRun& run) {
  run_ = run;
  try {
    link_ = std::make_unique<RunLink>(
        loop_, run,
        RunLink::Owner{[this](std::string line) { Queue(std::move(line)); },
                       [this](const std::string& why) {
                         link_.reset();
                         End(kCloseRunEnded, why);
                       },
                       [this] { connection_->SetReading(true); }});
  } catch (const std::exception& error) {
    End(kCloseNoRun, error.what());
  }
}

void Page::PassOnLastAnswers() {
  if (link_ != nullptr) link_->PassOnRest();
}

void Page::End(int code, const std::string& why) {
  if (is_closing_) return;
  Queue(JsonText(Json{{"event", "ended"}, {"why", why}}));
  is_closing_ = true;
  received_.clear();
  if (is_amid_message_) {
    connection_->SetReading(true);
    ending_ = Ending{code, why};
  } else {
    connection_->CloseWhenSent(code, why);
  }
}

// Drops a part of a message that comes while the page is closing.
void Page::Drop(size_t size, bool is_last) {
  if (!ending_) return;
  dropped_ += size;
  if (is_last) {
    connection_->CloseWhenSent(ending_->code, ending_->why);
    ending_.reset();
  } else if (dropped_ > kDropMax) {
    connection_->Abort();
    ending_.reset();
  }
}

void Page::Queue(std::string text) {
  if (is_closing_) return;
  if (queue_.Add(std::move(text))) {
    connection_->WantWrite();
  } else {
    // Closes the socket at once, without a reason.  Too many messages wait, because the page does
    // not read them, and the page would not read the reason either.
    is_closing_ = true;
    connection_->Abort();
  }
}

void Page::Collect() {
  for (std::string& text : answers_->TakeAll()) Queue(std::move(text));
}

std::string Page::Next() { return queue_.Next(); }

void Page::ReceivePart(std::string_view part, bool is_text, bool is_last) {
  is_amid_message_ = !is_last;
  if (is_closing_) return Drop(part.size(), is_last);
  if (!is_text) return End(kCloseNoText, "the page has sent a message that is no text");
  received_ += part;
  const size_t size_max = BeginsUpload(received_) ? kUploadMax : kMessageMax;
  if (received_.size() > size_max)
    return End(kCloseTooLong, fmt::format("a message of more than {} bytes", size_max));
  if (is_last) HandleRequest(std::exchange(received_, {}));
}

void Page::HandleRequest(const std::string& text) {
  nlohmann::json request;
  try {
    request = ParseJson<nlohmann::json>(text);
  } catch (const JsonTooDeep& error) {
    // Looks for the id of the request in the text, because JSON that is nested too deeply is not
    // read, and the page may wait for the answer with this id.
    return Refuse(PlainMember(text, "id"), error.what());
  } catch (const nlohmann::json::exception&) {
    request = nullptr;  // null is no object, so the next test refuses the request
  }
  if (!request.is_object()) return Refuse({}, "the request is no JSON object");
  // Copies the id, because CallRobot() moves the request away, and a refusal needs the id.
  const nlohmann::json id = request.value("id", nlohmann::json());
  try {
    CheckFractions(request, Fractions::kBounded);
    if (text.size() > kMessageMax && !IsUpload(request)) {
      End(kCloseTooLong, fmt::format("a message of more than {} bytes", kMessageMax));
    } else if (const std::string what = RequestReader(request).TextOr("do", ""); what == "runs") {
      runs_->Ask(answers_, id);
    } else if (what == "rc") {
      CallRobot(std::move(request), text.size());
    } else if (what == "pair") {
      CallPair(request);
    } else {
      PassOn(text, id);
    }
  } catch (const std::exception& error) {
    Refuse(id, error.what());
  }
}

void Page::PassOn(const std::string& text, const nlohmann::json& id) {
  if (link_ == nullptr) return Refuse(id, "this page has no run; the request runs lists them");
  std::string line = text;
  // Replaces line ends by spaces, which mean the same in JSON.  The run takes each line as a
  // request of its own, so this request must be one line.
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (!link_->Send(line)) connection_->SetReading(false);
}

void Page::CallRobot(nlohmann::json request, size_t size) {
  if (!allows_controllers_ && IsUpload(request) &&
      RequestReader(request).TextOr("kind", "") != "motion") {
    throw std::runtime_error(
        "a controller is code, so it cannot be uploaded through a panel that other computers "
        "reach; openr run --listen takes it with --allow-uploads");
  }
  RcBridge* const bridge = BridgeTo(request);
  bridge->Add(std::move(request), size);
}

RcBridge* Page::BridgeTo(const nlohmann::json& request) {
  const std::string endpoint = RequestReader(request).TextOr("endpoint", "run");
  const size_t robot = RobotOf(request);
  const std::string key = endpoint == "run" ? fmt::format("run {}", robot) : endpoint;
  const auto found = bridges_.find(key);
  if (found != bridges_.end()) return found->second.get();
  RcCalls::FindAddress find;
  if (endpoint == "run") {
    if (!run_) throw std::runtime_error("this page has no run; give the endpoint as HOST:PORT");
    find = [run = *run_, robot] { return AddressInRun(run, robot); };
  } else {
    find = [address = ParseEndpoint(endpoint)] { return address; };
  }
  if (bridges_.size() >= kEndpointsMax) {
    throw std::runtime_error(
        fmt::format("a page can use {} robots at most; open another page", kEndpointsMax));
  }
  // Makes the bridge before bridges_ gets an entry for it.  RcBridge() may throw, and bridges_ must
  // not keep an empty entry.
  auto bridge = std::make_unique<RcBridge>(std::move(find), answers_);
  return bridges_.emplace(key, std::move(bridge)).first->second.get();
}

// Carries out a call of the panel "Both dogs": connects a second robot to a robot of the run,
// disconnects it, or changes which robot follows the other, and how.
void Page::CallPair(const nlohmann::json& request) {
  const size_t robot = RobotOf(request);
  const std::string call = RequestReader(request).At("call").Text();
  const auto found = pairs_.find(robot);
  const bool is_there = found != pairs_.end() && !found->second->is_over();
  if (call == "connect") {
    if (!run_) throw std::runtime_error("this page has no run");
    if (is_there) throw std::runtime_error("a second robot is connected already; disconnect first");
    if (pairs_.size() >= kEndpointsMax && found == pairs_.end())
      throw std::runtime_error(fmt::format("a page can use {} pairs at most", kEndpointsMax));
    pairs_[robot] = std::make_unique<PairBridge>(*run_, robot, request, answers_);
    return;
  }
  if (call != "set" && call != "disconnect")
    throw std::runtime_error(
        fmt::format("'{}' is no call of a pair; known are connect, set, disconnect", call));
  if (!is_there) throw std::runtime_error("no second robot is connected");
  if (call == "set") found->second->Set(request);
  if (call == "disconnect") pairs_.erase(found);
  Json answer = Json::object();
  if (request.contains("id")) answer["id"] = request["id"];
  Queue(JsonText(answer));
}

void Page::Refuse(const nlohmann::json& id, const std::string& why) {
  Json answer = {{"error", why}};
  if (!id.is_null()) answer["id"] = id;
  Queue(JsonText(answer));
}

}  // namespace openr_host
