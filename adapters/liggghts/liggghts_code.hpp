// LIGGGHTS as a code: pair style gran hooke/stiffness with fix nve, plates as forces, a free lid as
// one atom that is pushed by the sum of these forces.
#pragma once

#include "adapters/program/program_code.hpp"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::adapters {

class LiggghtsCode final : public ProgramCode {
  public:
    /// `program`: name on PATH or path of the executable.
    explicit LiggghtsCode(std::string program = "liggghts");

    [[nodiscard]] std::string name() const override { return "liggghts"; }
    [[nodiscard]] Availability probe() const override;
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::Scene& scene) const override;
    [[nodiscard]] std::vector<InputFile> input(const scene::Scene& scene) const override;

  protected:
    [[nodiscard]] std::vector<std::string> command_line() const override;
    [[nodiscard]] std::vector<std::string> environment() const override;
    [[nodiscard]] std::optional<std::string>
    error_in(const std::string& stdout_text, const std::string& stderr_text) const override;

  private:
    std::string program_;
    mutable std::mutex mutex_;
    mutable std::optional<Availability> availability_;  // asked once per object
};

}  // namespace crossgrain::adapters
