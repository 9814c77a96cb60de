// Encodes and decodes OPEN-R calls: calls of OPENR:: functions that a program on a PC sends to the
// robot, and the robot's answers.
//
// A call or an answer is a row of 32-bit words, in the order of the reference (core.md, 5.4, "Proxy
// wire header"): number of bytes that follow, number of items (always 1), size of the item,
// command, then the arguments of the command:
//
//   FIND        name, 64 bytes                              FIND_REPLY   error, OID
//   SEND        OID, selector, size; the bytes              SEND_REPLY   error
//   CALL        OID, selector, size, reply size; the bytes  CALL_REPLY   error, size; the bytes
//
// Two facts are inferred, because the calls of Sony's TCPGateway were not measured: the item begins
// with its command, and the words of the answers have this order.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

enum class ProxyCommand : uint32_t {
  kUndefined = 0,
  kFind = 1,
  kFindReply = 2,
  kSend = 3,
  kSendReply = 4,
  kCall = 5,
  kCallReply = 6,
  kSendWithBox = 7,  // kSendWithBox and kReply are refused: their arguments are not known
  kReply = 8,
};

// Our limit for the bytes of an OPEN-R call, larger than any message of a system object (binary.md,
// 4).
inline constexpr uint32_t kProxyBytesMax = 256;

struct ProxyFrame {
  ProxyCommand command = ProxyCommand::kUndefined;
  std::string name = {};    // used in kFind: at most 63 characters
  uint32_t error = 0;       // used in answers: the result of the command, an sError
  uint32_t oid = 0;         // used in kFindReply, kSend and kCall
  uint32_t selector = 0;    // used in kSend and kCall
  uint32_t reply_size = 0;  // used in kCall: the answer is cut to this number of bytes
  std::string bytes = {};   // used in kSend, kCall and kCallReply
};

std::string EncodeProxyFrame(const ProxyFrame& frame);

// Decodes `item`, the bytes of one call or answer from GatewayStream::NextSet(), into `*frame`.
// Returns "" or the reason why `item` is invalid.
std::string DecodeProxyFrame(const std::string& item, ProxyFrame* frame);

}  // namespace openr_host
