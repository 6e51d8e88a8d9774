// LIGGGHTS as a code: pair style gran hooke/stiffness with fix nve, plates as forces, a free lid as
// one atom that is pushed by the sum of these forces.
#pragma once

#include "adapters/lammps_family/family_code.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::adapters {

class LiggghtsCode final : public lammps_family::FamilyCode {
  public:
    /// `program`: name on PATH or path of the executable.
    explicit LiggghtsCode(std::string program = "liggghts") : FamilyCode(std::move(program)) {}

    [[nodiscard]] std::string name() const override { return "liggghts"; }
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::Scene& scene) const override;

  protected:
    [[nodiscard]] std::vector<std::string> version_arguments() const override;
    [[nodiscard]] Availability availability_from(const std::string& help) const override;
    [[nodiscard]] std::string script(const scene::Scene& scene,
                                     const std::string& data_name) const override;
};

}  // namespace crossgrain::adapters
