// What a program is: the bytes of its executable and of all that it loads when it starts. The
// version that it states stays the same when it is built anew.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::adapters::process {

struct ProgramIdentity {
    std::filesystem::path program;  ///< absolute, symbolic links followed
    std::string digest;             ///< SHA-256, 64 hexadecimal digits
};

struct ProgramFiles {
    std::filesystem::path program;                     ///< as find_program gives it
    std::vector<std::filesystem::path> further_files;  ///< loaded later: plug-ins, modules
    std::vector<std::string> extra_environment;        ///< of its runs
};

/// The digest covers the executable, its shared libraries as the loader finds them, and the further
/// files with their libraries; of a script ("#!"), the script, its interpreter, and the programs
/// that it names by an absolute path or behind `exec`, `.` or `source`. It depends on the names and
/// contents of the files, not on the directories they are in. What a script starts otherwise, or a
/// program loads by itself later, is not known unless it is named. Throws std::system_error if a
/// file cannot be read or a library is missing, Interrupted on a stop request.
[[nodiscard]] ProgramIdentity identify(const ProgramFiles& files, const std::stop_token& stop);

}  // namespace crossgrain::adapters::process
