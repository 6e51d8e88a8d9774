#include "adapters/lammps_family/family_code.hpp"

#include "adapters/dump/data_writer.hpp"
#include "adapters/program/error_line.hpp"

namespace crossgrain::adapters::lammps_family {

std::vector<InputFile> FamilyCode::input(const scene::Scene& scene) const {
    constexpr const char* data_name = "data.txt";
    return {{.name = script_name(), .text = script(scene, data_name)},
            {.name = data_name, .text = dump::data_file(scene)}};
}

std::vector<std::string> FamilyCode::run_arguments() const {
    // Not -screen none: with it, LAMMPS prints errors nowhere.
    return {"-in", script_name(), "-log", "none", "-nocite"};
}

std::vector<std::string> FamilyCode::environment() const {
    return {"OMP_NUM_THREADS=1"};
}

std::optional<std::string> FamilyCode::error_in(const std::string& stdout_text,
                                                const std::string& stderr_text) const {
    const auto found = line_starting_with(stdout_text, "ERROR");
    return found ? found : line_starting_with(stderr_text, "ERROR");
}

}  // namespace crossgrain::adapters::lammps_family
