// Sony's OPEN-R SDK with its cross compiler: what makes images for the robot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

class RobotSdk {
 public:
  // The SDK that OPENRSDK_ROOT names.  Throws std::runtime_error that says what is missing: the
  // variable, a tool, or that it is this project's own tree, which is for the host.
  static RobotSdk FromEnvironment();

  // The SDK in `root`; throws as well.  Shows every command when `is_verbose`.
  explicit RobotSdk(const std::filesystem::path& root);
  void set_verbose(bool is_verbose) { is_verbose_ = is_verbose; }

  const std::filesystem::path& root() const { return root_; }

  // The base of a Memory Stick for `model` ("MS_ERS200"): `flavour` BASIC, WLAN or WCONSOLE.
  // Throws std::runtime_error that lists those that are there.
  std::filesystem::path BaseStick(const std::string& model, const std::string& flavour,
                                  bool is_protected) const;

  // All throw std::runtime_error when the tool fails, which then has said why itself.
  // Writes def.h, entry.h and the stub to `folder`.
  void GenerateStub(const std::filesystem::path& config, const std::filesystem::path& folder) const;

  // `options`: -I and -D.
  void Compile(const std::filesystem::path& source, const std::filesystem::path& object,
               const std::vector<std::string>& options) const;

  // `libraries`: "-lInternet".  Checks that what comes out is for the robot's processor.
  void Link(const std::filesystem::path& ocf, const std::vector<std::filesystem::path>& objects,
            const std::vector<std::string>& libraries, const std::filesystem::path& image) const;

  // The program that lists symbols of object files: the SDK's nm, else this machine's, which reads
  // them as well.
  std::string SymbolLister() const;

 private:
  void Run(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
           const std::string& what) const;
  std::string Tool(const char* name) const;

  std::filesystem::path root_;
  bool is_verbose_ = false;
};

// "" for a 32-bit little-endian MIPS program, else what the file is instead.
std::string WhyNotForRobot(const std::filesystem::path& image);

}  // namespace openr_host
