#include "runtime/gateway/proxy_server.h"

#include <fmt/format.h>
#include <sError.h>

#include <algorithm>
#include <iterator>

#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"
#include "runtime/gateway/system_messages.h"
#include "runtime/gateway/tcp_gateway.h"

namespace openr_host {
namespace {

// The system objects that a program on a PC can call.  The OID of an object is kFirstSystemOid plus
// the object's index in this array.
constexpr const char* kNames[] = {kVirtualRobot, kPowerManager, kDesignedRobot};
constexpr uint32_t kFirstSystemOid = 0x80000001;

uint32_t OidOfSystem(const std::string& name) {
  const auto found = std::find(std::begin(kNames), std::end(kNames), name);
  return found == std::end(kNames)
             ? 0
             : kFirstSystemOid + static_cast<uint32_t>(found - std::begin(kNames));
}

// Replaces control bytes and bytes that are not ASCII, because text from the network is shown on
// terminals, where such bytes can do harm.
std::string WithoutControls(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

}  // namespace

void ProxyServer::Received(std::string_view bytes) {
  stream_.Feed(bytes);
  GatewaySet set;
  GatewayStream::Result result;
  while ((result = stream_.NextSet(&set)) == GatewayStream::Result::kTaken) {
    ProxyFrame frame;
    const std::string problem = set.size() == 1
                                    ? DecodeProxyFrame(set[0], &frame)
                                    : fmt::format("has {} items; a call has one", set.size());
    if (!problem.empty()) return connection_.Refuse(problem);
    const ProxyFrame answer = AnswerTo(frame);
    if (answer.command == ProxyCommand::kUndefined)
      return connection_.Refuse("has an answer where a call is expected");
    connection_.Send(EncodeProxyFrame(answer));
  }
  if (result == GatewayStream::Result::kBroken) connection_.Refuse(stream_.error());
}

ProxyFrame ProxyServer::AnswerTo(const ProxyFrame& frame) {
  ProxyFrame answer;
  switch (frame.command) {
    case ProxyCommand::kFind:
      answer.command = ProxyCommand::kFindReply;
      answer.oid = OidOfSystem(frame.name);
      if (answer.oid == 0) {
        answer.error = sOBJNOTFOUND;
        gateway_->Warn(fmt::format(
            "a program on another computer looks for '{}'; {}, {} and {} can be called from there",
            WithoutControls(frame.name), kVirtualRobot, kPowerManager, kDesignedRobot));
      }
      break;
    case ProxyCommand::kCall:
      return AnswerCall(frame);
    case ProxyCommand::kSend:
      answer.command = ProxyCommand::kSendReply;
      answer.error = static_cast<uint32_t>(AnswerCall(frame).error);
      break;
    default:
      break;
  }
  return answer;
}

ProxyFrame ProxyServer::AnswerCall(const ProxyFrame& frame) {
  ProxyFrame answer;
  answer.command = ProxyCommand::kCallReply;
  if (frame.oid < kFirstSystemOid || frame.oid - kFirstSystemOid >= std::size(kNames)) {
    answer.error = sINVALIDOID;
    return answer;
  }
  const Robot& robot = gateway_->system().robot(gateway_->host().robot);
  std::string why;
  answer.bytes =
      AnswerSystemMessage(robot.services.get(), robot.design, kNames[frame.oid - kFirstSystemOid],
                          frame.selector, frame.bytes, &why);
  if (!why.empty()) gateway_->Warn(fmt::format("a call of a program on another computer: {}", why));
  if (answer.bytes.empty()) answer.error = sFAIL;
  answer.bytes.resize(std::min<size_t>(answer.bytes.size(), frame.reply_size));
  return answer;
}

}  // namespace openr_host
