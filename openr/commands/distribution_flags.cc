#include "openr/commands/distribution_flags.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>

#include "cli/input_file.h"
#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "distribution/dds_settings.h"
#include "openr/commands/common_flags.h"
#include "openr/ros2/ros2_link.h"
#include "openr/simulation/run_stick.h"
#include "runtime/base/read_file.h"

namespace openr_host {

void AddBusFlags(CLI::App* command, BusOptions* bus) {
  command->add_option("--dds-domain", bus->domain, "DDS domain")
      ->check(CLI::Range(0, 230))
      ->capture_default_str();
  command->add_option("--dds-address", bus->address, "Address of this host's network interface")
      ->capture_default_str();
  command->add_option("--dds-peer", bus->peers, "Address of another host of the run; repeatable");
  command
      ->add_option(
          "--dds-lease", bus->lease_s,
          "Seconds without a sign of life after which a process is gone (default: 10; 3600 "
          "for those of this host, whose end the run sees, 60 with --restart)")
      ->check(CLI::Range(1, kWatchedLease_s));
  command
      ->add_option("--dds-config", bus->config_file,
                   "File with settings of Cyclone DDS that are added (security)")
      // Refuses a folder as the value of --dds-config.  Cyclone DDS would take the folder for an
      // empty file, and the run would lack the security settings that the user wants.
      ->check(IsReadable("--dds-config", "file with settings of Cyclone DDS", ".xml"));
  // Checks that the file of --dds-config is for the DDS domain of --dds-domain, because Cyclone DDS
  // silently ignores settings for another domain.  The check needs both flags, so it runs after all
  // flags have been read.
  command->parse_complete_callback([bus] {
    if (bus->config_file.empty()) return;
    const std::string problem = DomainProblem(bus->config_file, bus->domain);
    if (problem.empty()) return;
    RefuseInput("--dds-config", bus->config_file, problem);
  });
}

CLI::Validator IsNameOf(const std::string& what) {
  return {[what](const std::string& name) { return NameProblem(what, name); }, ""};
}

void AddPlacementFlags(CLI::App* command, PlacementFlags* flags) {
  command->add_option("--place", flags->places,
                      "OBJECT=PROCESS: run an object in a process of this name; repeatable");
  command->add_option("--placement", flags->file, "File that says where objects run")
      ->check(IsReadable("--placement", "placement file (docs/distribution.md)", ".cfg"));
  command->add_option("--isolate", flags->isolated,
                      "Run this object in a process of its own; repeatable");
  command->add_option("--wrap", flags->wrapper,
                      "What the processes are started with: 'gdb --args', 'valgrind -q'");
  command->add_flag("--free-running", flags->is_free,
                    "Processes run at the same time, as the wall clock has it; no run is like "
                    "another");
  command
      ->add_option(
          "--restart", flags->restarts,
          "Start a process that was lost again, at most this often; its objects begin anew")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  command->add_flag("--monitor", flags->is_monitored,
                    "Speak to openr top; a run in several processes or with --ros2 does anyway");
  command
      ->add_option(
          "--run-name", flags->bus.run,
          "Name of the run, for openr poke and join (default: one of its own; openr when a "
          "process is on another host)")
      ->check(IsNameOf("run"));
  AddDurationFlag(command, "--join-wait", &flags->wait_us, "How long to wait for a process");
  AddBusFlags(command, &flags->bus);
  for (const char* name : {"--wrap", "--restart", "--join-wait"})
    flags->of_processes.push_back(command->get_option(name));
  for (const char* name :
       {"--dds-domain", "--dds-address", "--dds-peer", "--dds-lease", "--dds-config"})
    flags->of_dds.push_back(command->get_option(name));
}

void RefuseIdleFlags(const PlacementFlags& flags, bool has_processes, bool has_dds) {
  const std::string alone = "no object is placed in another process (--place)";
  const auto refuse = [](const std::vector<const CLI::Option*>& options, const std::string& why) {
    for (const CLI::Option* option : options) {
      if (option->count() > 0) throw CLI::ValidationError(option->get_name(), why);
    }
  };
  if (!has_processes) refuse(flags.of_processes, alone);
  if (!has_dds)
    refuse(flags.of_dds, alone + ", and without --ros2 and --monitor nobody else is spoken to");
}

void AddRos2Flags(CLI::App* command, Ros2Flags* flags) {
  CLI::Option* const on = command->add_flag(
      "--ros2", flags->is_on,
      "Joint states, sensors, images and clock as topics of ROS 2, and commands for joints back; "
      "with --dds-domain and the other flags of DDS");
  command
      ->add_option("--ros2-namespace", flags->space,
                   "Namespace of the robot's topics; of several robots with their number after it")
      ->needs(on)
      ->check(CLI::Validator(&WrongNamespace, "NAME"))
      ->capture_default_str();
}

namespace {

Placement ReadPlacement(const std::string& file) {
  const std::optional<std::string> text = ReadFile(file);
  if (!text) RefuseInput("--placement", file, std::strerror(errno));
  std::vector<Diagnostic> diagnostics;
  Placement placement = ParsePlacement(file, *text, &diagnostics);
  if (!diagnostics.empty()) throw CLI::ValidationError("--placement", Render(diagnostics));
  return placement;
}

Placement PlacementOf(const PlacementFlags& flags) {
  Placement placement = flags.file.empty() ? Placement() : ReadPlacement(flags.file);
  for (const std::string& place : flags.places) {
    const std::string problem = AddPlace(place, &placement);
    if (!problem.empty()) throw CLI::ValidationError("--place", place + ": " + problem);
  }
  for (const std::string& object : flags.isolated) {
    const std::string problem = AddPlace(object + "=" + object, &placement);
    if (!problem.empty()) throw CLI::ValidationError("--isolate", object + ": " + problem);
  }
  return placement;
}

std::string UniqueRunName() { return fmt::format("openr-{}", getpid()); }

std::vector<std::string> WordsOf(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

// Returns the lease of the workers that this run starts: the seconds without a sign of life after
// which a worker counts as dead.  This is the value of --dds-lease or, without this flag, a long
// time.  With --restart the time is shorter, because DDS keeps data for a dead worker until its
// lease is over, and these data slow down the restart (bus.h).  But workers under a debugger
// (--wrap) keep the long time, because the user may stop a worker for long.
int OwnWorkerLease(const PlacementFlags& flags) {
  if (flags.bus.lease_s != 0) return flags.bus.lease_s;
  return flags.restarts > 0 && flags.wrapper.empty() ? kReturningLease_s : kWatchedLease_s;
}

}  // namespace

std::unique_ptr<WorkerGroup> MakeWorkerGroup(const PlacementFlags& flags, const RunStick& stick,
                                             int64_t handler_limit_us,
                                             std::function<int()> interrupts) {
  WorkerGroupOptions options;
  options.placement = PlacementOf(flags);
  if (options.placement.empty()) {
    if (!flags.is_free) return nullptr;
    throw CLI::ValidationError("--free-running",
                               "no object is placed in another process (--place)");
  }
  const auto wrong_hosts = WrongHosts(options.placement, flags.bus.address);
  if (!wrong_hosts.empty()) throw CLI::ValidationError("--placement", Render(wrong_hosts));
  options.bus = flags.bus;
  // Gives the run a fixed name if processes run on other hosts, because the users there have to
  // start `openr join` with the same name.
  if (options.bus.run.empty())
    options.bus.run = options.placement.host_of.empty() ? UniqueRunName() : "openr";
  const int own_worker_lease_s = OwnWorkerLease(flags);
  // If this run starts all workers, gives this process the lease `own_worker_lease_s`, too.  A long
  // lease does no harm then, because these workers end together with this process (--child-of).
  // But a worker on another host notices a crash of this process only when the lease of this
  // process is over.  So with such a worker, this process keeps the value of --dds-lease, which is
  // short by default.
  if (options.placement.host_of.empty()) options.bus.lease_s = own_worker_lease_s;
  for (const auto& [process, host] : options.placement.host_of) options.bus.peers.push_back(host);
  options.stick = std::filesystem::absolute(stick.folder()).lexically_normal();
  options.wait_ms = flags.wait_us / 1000;
  options.restarts = flags.restarts;
  options.interrupts = std::move(interrupts);
  options.wrapper = WordsOf(flags.wrapper);
  options.is_free = flags.is_free;
  options.command = {ProgramFile(),     "join",
                     "--child-of",      std::to_string(getpid()),
                     "--run-name",      options.bus.run,
                     "--dds-domain",    std::to_string(options.bus.domain),
                     "--dds-address",   options.bus.address,
                     "--dds-lease",     std::to_string(own_worker_lease_s),
                     "--handler-limit", fmt::format("{}us", handler_limit_us)};
  if (!stick.crash_log().empty())
    options.command.insert(options.command.end(), {"--crash-log", stick.crash_log()});
  if (!options.bus.config_file.empty()) {
    options.bus.config_file = std::filesystem::absolute(options.bus.config_file);
    options.command.insert(options.command.end(), {"--dds-config", options.bus.config_file});
  }
  options.say = [](const std::string& line) { PrintPlain(stderr, "openr: {}\n", line); };
  return std::make_unique<WorkerGroup>(std::move(options));
}

std::unique_ptr<Bus> MakeBus(const PlacementFlags& flags) {
  BusOptions bus = flags.bus;
  if (bus.run.empty()) bus.run = UniqueRunName();
  return std::make_unique<Bus>(bus);
}

}  // namespace openr_host
