// A small reading of the gas's rules and a small [scene] table, and how to read variations of them.
#pragma once

#include "cases/scene/gas_reading_file.hpp"
#include "cases/scene/model_file.hpp"
#include "tests/cases/scene/scene_text.hpp"
#include "tests/cases/toml/refusal.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace crossgrain::tests {

inline const std::string shipped_readings =
    std::string(CROSSGRAIN_SOURCE_DIR) + "/cases/catalog/readings";

/// The rows begin at line 4.
inline std::string reading_with(const std::string& rows) {
    return "walls = \"outside\"\nrelocation = \"origin-first\"\ncollision = [\n" + rows +
           "\n]\n[gravity]\nrest_to_down = true\nup_diagonals = true\nup_to_rest = false\n"
           "on_walls = false\n";
}

/// A file of its own, gone with the object.
class TextFile {
  public:
    explicit TextFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() /
                ("reading-" + std::to_string(getpid()) + ".toml")) {
        std::ofstream(path_) << text;
    }
    ~TextFile() { std::filesystem::remove(path_); }
    TextFile(const TextFile&) = delete;
    TextFile& operator=(const TextFile&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

inline scene::GasReading read_rows(const std::string& rows) {
    const TextFile file(reading_with(rows));
    return scene::load_gas_reading(file.path());
}

inline const std::string gas_text = R"(reading = "P"
length = 220
width = 11
ends = "periodic"
density = 1.0
dissipation = 0.8
gravity = 0.5
roughness = 0.25
sample = { bin = 10, replicas = 64, burn_in = 100, steps = 1000, every = 10 }
)";

inline scene::LatticeGas read_gas(const std::string& text, std::uint64_t seed = 1) {
    const toml::table root = toml::parse(text);
    return scene::read_lattice_gas(toml_input::TomlTable("case.toml", "scene", {&root}),
                                   {.name = "test", .seed = seed, .readings = shipped_readings});
}

inline const std::string signal_text = R"(length = 220
width = 11
mean = 1000
noise = 50
exponent = 1.33
wave_amplitude = 20
wave_velocity = 0.36
sample = { bin = 10, replicas = 8, steps = 1000, every = 10 }
)";

inline scene::SyntheticSignal read_signal(const std::string& text) {
    const toml::table root = toml::parse(text);
    return scene::read_synthetic_signal(toml_input::TomlTable("case.toml", "scene", {&root}),
                                        {.name = "test", .seed = 3});
}

}  // namespace crossgrain::tests
