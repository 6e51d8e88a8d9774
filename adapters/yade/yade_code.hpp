// YADE as a code: Luding's law (attraction kept) or the viscoelastic law (attraction cut), plates
// as forces on the grains near them, in a Python script that reads the scene as JSON.
#pragma once

#include "adapters/program/program_code.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::adapters {

class YadeCode final : public ProgramCode {
  public:
    /// `program`: name on PATH or path of the executable.
    explicit YadeCode(std::string program = "yade") : ProgramCode(std::move(program)) {}

    [[nodiscard]] std::string name() const override { return "yade"; }
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::Scene& scene) const override;
    /// The scripts, which are the same for all scenes, and the scene; plates only if it has any
    /// or backing planes.
    [[nodiscard]] std::vector<InputFile> input(const scene::Scene& scene) const override;

  protected:
    [[nodiscard]] std::vector<std::string> version_arguments() const override;
    [[nodiscard]] Availability availability_from(const std::string& answer) const override;
    [[nodiscard]] std::vector<std::filesystem::path>
    further_files(const std::filesystem::path& executable) const override;
    [[nodiscard]] std::vector<std::string> run_arguments() const override;
    [[nodiscard]] std::vector<std::string> environment() const override;
    [[nodiscard]] std::optional<std::string>
    error_in(const std::string& stdout_text, const std::string& stderr_text) const override;
};

}  // namespace crossgrain::adapters
