#include "runtime/gateway/proxy_wire.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/gateway/gateway_stream.h"

namespace openr_host {
namespace {

constexpr size_t kNameBytes = 64;

// Reads the 32-bit words at the beginning of an item.  An item has the bytes of one call of an
// OPENR:: function, or of the answer to such a call.
class ItemReader {
 public:
  explicit ItemReader(const std::string& item) : item_(item) {}

  std::optional<uint32_t> Word() {
    if (item_.size() - at_ < 4) return std::nullopt;
    uint32_t word = 0;
    for (size_t i = 0; i < 4; ++i)
      word |= static_cast<uint32_t>(static_cast<unsigned char>(item_[at_ + i])) << (8 * i);
    at_ += 4;
    return word;
  }
  // Reads one 32-bit word of the item (a call or answer) into each argument.  Returns false if the
  // item has fewer words.
  template <typename... Words>
  bool ReadNumbers(Words*... words) {
    return (ReadNumber(words) && ...);
  }
  std::string Rest() const { return item_.substr(at_); }

 private:
  bool ReadNumber(uint32_t* to) {
    const std::optional<uint32_t> word = Word();
    if (word) *to = *word;
    return word.has_value();
  }

  const std::string& item_;
  size_t at_ = 0;
};

const char* NameOf(ProxyCommand command) {
  constexpr const char* kNames[] = {"UNDEF",      "FIND", "FIND_REPLY", "SEND",
                                    "SEND_REPLY", "CALL", "CALL_REPLY"};
  return kNames[static_cast<size_t>(command)];
}

// Reads the arguments of the command `frame->command` from `reader`, which reads an item: the bytes
// of one call or answer.  Sets `*size` to the number of bytes that must follow the arguments;
// leaves `*size` as it is if the command has no such bytes.  Returns false if the item is too
// short.
bool ReadWords(ItemReader* reader, ProxyFrame* frame, uint32_t* size) {
  switch (frame->command) {
    case ProxyCommand::kFind:
      *size = kNameBytes;
      return true;
    case ProxyCommand::kFindReply:
      return reader->ReadNumbers(&frame->error, &frame->oid);
    case ProxyCommand::kSend:
      return reader->ReadNumbers(&frame->oid, &frame->selector, size);
    case ProxyCommand::kSendReply:
      return reader->ReadNumbers(&frame->error);
    case ProxyCommand::kCall:
      return reader->ReadNumbers(&frame->oid, &frame->selector, size, &frame->reply_size);
    default:
      return reader->ReadNumbers(&frame->error, size);
  }
}

}  // namespace

std::string EncodeProxyFrame(const ProxyFrame& frame) {
  std::string item = EncodeWord(static_cast<uint32_t>(frame.command));
  const auto add = [&item](auto... words) { ((item += EncodeWord(words)), ...); };
  const auto size = static_cast<uint32_t>(frame.bytes.size());
  switch (frame.command) {
    case ProxyCommand::kFind: {
      std::string name = frame.name.substr(0, kNameBytes - 1);
      name.resize(kNameBytes, '\0');
      item += name;
      break;
    }
    case ProxyCommand::kFindReply:
      add(frame.error, frame.oid);
      break;
    case ProxyCommand::kSend:
      add(frame.oid, frame.selector, size);
      break;
    case ProxyCommand::kSendReply:
      add(frame.error);
      break;
    case ProxyCommand::kCall:
      add(frame.oid, frame.selector, size, frame.reply_size);
      break;
    default:
      add(frame.error, size);
      break;
  }
  return EncodeSet({item + frame.bytes});
}

std::string DecodeProxyFrame(const std::string& item, ProxyFrame* frame) {
  *frame = {};
  ItemReader reader(item);
  const uint32_t command = reader.Word().value_or(0);
  if (command < static_cast<uint32_t>(ProxyCommand::kFind) ||
      command > static_cast<uint32_t>(ProxyCommand::kReply))
    return fmt::format("has the command {}, which no source names", command);
  if (command > static_cast<uint32_t>(ProxyCommand::kCallReply))
    return fmt::format(
        "has the command {} ({}), whose layout is not known and which is not carried", command,
        command == 7 ? "SENDWITHRBOX" : "REPLY");
  frame->command = static_cast<ProxyCommand>(command);
  uint32_t size = 0;
  if (!ReadWords(&reader, frame, &size))
    return fmt::format("ends within the words of {}", NameOf(frame->command));
  std::string rest = reader.Rest();
  if (size > kProxyBytesMax || rest.size() != size) {
    return fmt::format("has {} bytes in a {} that announces {}; {} is the limit", rest.size(),
                       NameOf(frame->command), size, kProxyBytesMax);
  }
  if (frame->command == ProxyCommand::kFind) {
    frame->name = rest.substr(0, std::min(rest.find('\0'), kNameBytes - 1));
  } else {
    frame->bytes = std::move(rest);
  }
  return "";
}

}  // namespace openr_host
