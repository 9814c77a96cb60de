#include "openr/commands/listen_flags.h"

namespace openr_host {

void AddListenFlags(CLI::App* command, ListenOptions* options) {
  CLI::Option* const listen =
      command
          ->add_option("--listen", options->address,
                       "Let other computers use panel and remote control at this address of this "
                       "computer; 0.0.0.0: at all of them (docs/threats.md)")
          ->type_name("ADDRESS")
          ->check(CLI::Validator(&ListenAddressProblem, ""));
  CLI::Option* const token = command
                                 ->add_option("--token-file", options->token_file,
                                              "File with the token that they need; made if it is "
                                              "not there")
                                 ->needs(listen);
  listen->needs(token);
  command
      ->add_option("--listen-rc-port", options->rc_port,
                   "Port of the remote control at that address, or the next free one; 0: any")
      ->needs(listen)
      ->capture_default_str();
  command
      ->add_flag("--allow-uploads", options->allows_controllers,
                 "Let them upload controllers, which run as code of this user")
      ->needs(listen);
}

}  // namespace openr_host
