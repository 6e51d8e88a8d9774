// LAMMPS and its fork LIGGGHTS as programs: started alike, with an input script and a data file of
// the same format, and reporting errors alike.
#pragma once

#include "adapters/program/program_code.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::adapters::lammps_family {

class FamilyCode : public ProgramCode {
  public:
    /// The script and the data file with the initial state.
    [[nodiscard]] std::vector<InputFile> input(const scene::Scene& scene) const final;

  protected:
    using ProgramCode::ProgramCode;

    /// The input script: reads the initial state from `data_name` and writes the frames to
    /// `ProgramCode::dump_name`.
    [[nodiscard]] virtual std::string script(const scene::Scene& scene,
                                             const std::string& data_name) const = 0;

    [[nodiscard]] std::vector<std::string> run_arguments() const final;
    [[nodiscard]] std::vector<std::string> environment() const final;
    [[nodiscard]] std::optional<std::string> error_in(const std::string& stdout_text,
                                                      const std::string& stderr_text) const final;

  private:
    [[nodiscard]] std::string script_name() const { return "in." + name(); }
};

}  // namespace crossgrain::adapters::lammps_family
