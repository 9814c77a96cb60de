// The flags by which other computers reach the panel and the remote control.
#pragma once

#include <CLI/CLI.hpp>

#include "openr/panel/listen.h"

namespace openr_host {

// Adds --listen, --token-file, --listen-rc-port and --allow-uploads to `command`.
void AddListenFlags(CLI::App* command, ListenOptions* options);

}  // namespace openr_host
