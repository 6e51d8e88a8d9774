// The frames of earlier runs that --keep-dumps kept, for measuring them again without starting the
// code. They are the dump in a run's directory (adapters/code.hpp) and, once it is whole, a record
// beside it that tells what they are.
#pragma once

#include "adapters/code.hpp"
#include "adapters/run/monitor.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

namespace crossgrain::run {

/// What decides the frames (frames_key), and for readers of the record the code.
struct FramesIdentity {
    std::string key;  ///< SHA-256 in hexadecimal
    std::string code, version;
};

struct KeptFrames {
    std::filesystem::path dump;
    adapters::RunCost cost;  ///< of the run that wrote them
};

/// What the directory of a run is called, but for the number of its process: readable, and no other
/// run's. By it the frames are found again. `name`, `code`, `replica`: labels only.
[[nodiscard]] std::string frames_directory_stem(const std::string& name,
                                                const FramesIdentity& frames, std::int64_t replica);

/// Writes the record <directory>/frames.json of a dump that is whole. Throws CaseError if it cannot
/// be written, std::system_error if the dump cannot be read.
void record_frames(const std::filesystem::path& directory, const FramesIdentity& frames,
                   const adapters::RunCost& cost);

/// Those of this key in the directories below `runs`, if there are any. The dump is the one that
/// was recorded, to the byte; what is not is passed over, and `monitor` is told why. Throws
/// Interrupted.
[[nodiscard]] std::optional<KeptFrames> find_frames(const std::filesystem::path& runs,
                                                    const FramesIdentity& frames, Monitor& monitor,
                                                    const std::stop_token& stop);

/// The line about frames that cannot be measured, for who asked for the run.
[[nodiscard]] std::string frames_refusal(const std::filesystem::path& directory,
                                         const std::string& reason);

}  // namespace crossgrain::run
