// The fuzz target remote_answer: packets of a robot, as a client reads them.
#include <algorithm>

#include "RemoteFiles.h"
#include "RemoteLog.h"
#include "RemotePacket.h"
#include "RemoteProtocol.h"
#include "RemoteStreams.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::remote_answer(std::string_view bytes) {
  RcFramer framer;
  for (size_t at = 0; at < bytes.size();) {
    const auto count = std::min<size_t>(bytes.size() - at, static_cast<size_t>(framer.Room()));
    framer.Append(reinterpret_cast<const Uint8*>(bytes.data() + at), static_cast<int>(count));
    at += count;
    RcFramer::Result result;
    while ((result = framer.Next()) == RcFramer::PACKET) {
      RcAnswerHeader header;
      header.Read(framer);
    }
    if (result == RcFramer::BROKEN) break;
  }
  RcPower power;
  RcSensors sensors;
  RcSetValues values;
  RcInfo info;
  RcDescription description;
  RcJointState joint;
  RcGains gains;
  RcPlayAnswer play;
  RcList list;
  const auto reads = [bytes](auto* payload) {
    RcReader reader(reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(bytes.size()));
    return payload->Read(&reader);
  };
  const bool has_power = reads(&power);
  const bool has_sensors = reads(&sensors);
  const bool has_values = reads(&values);
  const bool has_info = reads(&info);
  reads(&description);
  reads(&joint);
  reads(&gains);
  reads(&play);
  const bool has_list = reads(&list);
  return has_info ? info.hasFiles && info.numLeds == 9
                  : has_power || has_values || (has_sensors && has_list);
}

}  // namespace openr_host
