// Errors that cross module boundaries. Bad input names the file, line, column and key; a failed
// foreign program names its command, exit status, log tail and directory. Physical disagreement is
// never an exception: it is a verdict (reference/compare/verdict.hpp).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace crossgrain {

/// Bad usage or bad input (exit code 2). All that is known about where and what, in one line.
struct CaseErrorDetails {
    std::string file;      ///< path as the user gave it; empty when no file is involved
    int line = 0;          ///< 1-based; 0 when unknown
    int column = 0;        ///< 1-based; 0 when unknown
    std::string key;       ///< dotted key, e.g. "scene.contact.restitution"
    std::string problem;   ///< what is wrong, e.g. "is out of range"
    std::string got;       ///< what was found
    std::string expected;  ///< what would be right
    std::string hint;      ///< what to do, e.g. "did you mean 'restitution'?"
};

class CaseError : public std::runtime_error {
  public:
    /// Escapes what cannot be shown (printable.hpp), in the details as well.
    explicit CaseError(const CaseErrorDetails& details);
    [[nodiscard]] const CaseErrorDetails& details() const noexcept { return details_; }

  private:
    CaseErrorDetails details_;
};

/// A run of a code that did not deliver (verdict `run_failed`, exit code 3).
struct AdapterErrorDetails {
    std::string code;        ///< name of the code, e.g. "lammps"
    std::string reason;      ///< one line, e.g. "dump ends in the middle of frame 2000"
    std::string command;     ///< argv joined by spaces; empty for a native engine
    std::string exit;        ///< e.g. "exit status 1", "killed at the time limit of 60 s"
    std::string log_tail;    ///< last lines of its output
    std::string directory;   ///< where inputs and logs are kept; empty when none
    bool timed_out = false;  ///< it was ended at the time limit
};

class AdapterError : public std::runtime_error {
  public:
    explicit AdapterError(const AdapterErrorDetails& details);
    [[nodiscard]] const AdapterErrorDetails& details() const noexcept { return details_; }

  private:
    AdapterErrorDetails details_;
};

/// A trajectory, of whatever origin, that cannot be what the scene asked for: not finite, wrong
/// number of grains, frames that overlap, a grain that jumps over its neighbours in one step.
class TrajectoryError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The user asked to stop (Ctrl-C). What is already stored stays stored.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace crossgrain
