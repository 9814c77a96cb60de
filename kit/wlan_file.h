// Writes WLANCONF.TXT, the network settings of the robot, and checks that they fit together.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/wlan_config.h"

namespace openr_host {

// A setting of WLANCONF.TXT that a user can give: by a flag, or as the answer to a question.
struct WlanQuestion {
  const char* key;       // key in the file, such as "ETHER_IP"
  const char* flag;      // flag of the command, such as "--ip"
  const char* question;  // text of the question, such as "Address of the robot"
  bool is_yes_no;        // true: the file has 1 for yes and 0 for no
  // Returns whether the setting has a meaning with the present values of the other settings.  If
  // not, the user is not asked for the setting.
  bool (*is_asked)(const WlanConfig& config);
};

// Returns all settings of WLANCONF.TXT, in the order in which they are asked and written.
const std::vector<WlanQuestion>& WlanQuestions();

// Sets `key` to `value`, as a line KEY=VALUE of WLANCONF.TXT does.  Returns "", or the reason why
// the robot would not accept the value ("CHANNEL must be a number from 1 to 11").
std::string SetWlanKey(const std::string& key, const std::string& value, WlanConfig* config);

// Returns the value of `key`, written as in WLANCONF.TXT; "" if the key has no value.
std::string WlanValue(const WlanConfig& config, const std::string& key);

// Calls `ask` for each question and stores the answers in `config`.  `ask` gets the text of the
// question and the present value, which stays if the answer is empty.  `ask` returns the answer, or
// nullopt at the end of the input.  The answer to a question with `is_yes_no` may be yes, y, no or
// n as well as 1 or 0.  If the robot would not accept an answer, calls `refuse` with the reason,
// and asks the question again.  Returns false if the input ended before the last question.
bool AskForWlan(const std::function<std::optional<std::string>(const std::string& question,
                                                               const std::string& value)>& ask,
                const std::function<void(const std::string& reason)>& refuse, WlanConfig* config);

// Returns the text of a WLANCONF.TXT, with the line ends of Sony's file.  Leaves out settings that
// another setting makes meaningless, such as the key of a network without encryption.
std::string WlanText(const WlanConfig& config);

// Returns warnings about settings that are valid but do not fit together, such as a gateway that is
// not in the robot's network.  Returns no warnings if the file has errors.  The warnings name
// `file`.
std::vector<Diagnostic> CheckWlanSettings(const std::string& file, const WlanResult& settings);

}  // namespace openr_host
