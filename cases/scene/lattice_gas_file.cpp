#include "cases/scene/gas_reading_file.hpp"
#include "cases/scene/gas_sampling_file.hpp"
#include "cases/scene/model_file.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::Range;

std::vector<std::string> shipped_readings(const std::filesystem::path& directory) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

/// The file of a reading: a path relative to the case file, or a name of the shipped ones.
std::string reading_file(const KeyedTable& t, const std::string& readings) {
    namespace fs = std::filesystem;
    const std::string given = t.text("reading");
    fs::path path;
    std::error_code ignored;  // a name may be longer than any file's
    if (given.find('/') != std::string::npos || given.ends_with(".toml")) {
        path = fs::path(t.file()).parent_path() / given;
        if (fs::is_regular_file(path, ignored)) return path.string();
        throw t.error("reading", "cannot be read", fmt::format("\"{}\"", given),
                      "a TOML file, by its path from the case file");
    }
    path = fs::path(readings) / (given + ".toml");
    if (fs::is_regular_file(path, ignored)) return path.string();
    const auto names = shipped_readings(readings);
    const auto near = toml_input::nearest(given, names);
    throw t.error(
        "reading", "is not known", fmt::format("\"{}\"", given),
        fmt::format("one of \"{}\", or the path of a TOML file", fmt::join(names, "\", \"")),
        near ? fmt::format("did you mean \"{}\"?", *near) : "");
}

Range fraction() {
    return {.low = 0, .high = 1, .low_open = false, .text = "a number in [0, 1]"};
}

void refuse_without(const KeyedTable& t, const char* key, const char* of, const char* ends) {
    if (!t.has(key)) return;
    throw t.error(key, "contradicts", fmt::format("ends = \"{}\" as well", ends),
                  fmt::format("'{}' with {} pipes only", key, of), "remove one");
}

/// Seven particles at a site of the interior, and two that arrive at a wall site: wall columns
/// inside the width W leave less room than the rho <= 7 of the paper's model.
void check_capacity(const KeyedTable& t, const LatticeGas& gas) {
    const int interior = gas.sampling.width - (gas.reading.walls == WallPlace::inside ? 2 : 0);
    const double most = (7.0 * interior + 4.0) / gas.sampling.width;
    if (gas.density <= most) return;
    throw t.error("density", "is more than the pipe can hold", fmt::format("{:g}", gas.density),
                  fmt::format("at most {:.4g} for width {} with walls {}", most, gas.sampling.width,
                              to_string(gas.reading.walls)));
}

/// Bytes that the engines need. Per site, the bit-sliced one has 22 words of 256 bits (seven
/// states, nine digits of relocation, six of collisions) for each 256 replicas, and six neighbours;
/// the table engine has 6 bytes per replica. Both choose the start among seven slots of 8 bytes, in
/// arrays that grow by doubling.
double memory_of(const LatticeGas& gas) {
    const double sites = static_cast<double>(gas.sampling.length) * (gas.sampling.width + 2);
    const double words = 22.0 * 32 * std::ceil(gas.sampling.replicas / 256.0);
    const double states = gas.engine == GasEngine::table ? 6.0 * gas.sampling.replicas : words + 32;
    return sites * (states + 2 * 56);
}

void check_memory(const KeyedTable& t, const LatticeGas& gas) {
    const double bytes = memory_of(gas);
    if (bytes <= memory_budget()) return;
    throw t.error("length", "makes too large a pipe",
                  fmt::format("{} for {} x {} sites and {} replicas", shown_bytes(bytes),
                              gas.sampling.length, gas.sampling.width, gas.sampling.replicas),
                  fmt::format("at most {}", shown_bytes(memory_budget())),
                  "a shorter or narrower pipe, or fewer replicas");
}

/// A periodic pipe is filled, an open one starts empty and is fed.
void read_filling(const KeyedTable& t, LatticeGas& gas) {
    if (gas.ends == PipeEnds::periodic) {
        gas.density = t.number("density");
        check_capacity(t, gas);
        const double particles = gas.density * gas.sampling.length * gas.sampling.width;
        if (std::round(particles) < 1) {
            throw t.error("density", "makes an empty pipe",
                          fmt::format("{:g}, which is {:.3g} particles in {} x {} sites",
                                      gas.density, particles, gas.sampling.length,
                                      gas.sampling.width),
                          "at least one particle");
        }
        refuse_without(t, "injection", "open", "periodic");
    } else {
        gas.injection = t.number("injection");
        refuse_without(t, "density", "periodic", "open");
    }
}

}  // namespace

const toml_input::TableKeys& lattice_gas_keys() {
    using enum toml_input::Need;
    static const toml_input::TableKeys keys = [] {
        toml_input::TableKeys scene{
            .name = "scene",
            .keys = {{"reading", toml_input::TextRule{},
                      "of the rules: one that is shipped, or the path of a file", required},
                     {"ends", ChoiceRule{all_words<PipeEnds>()}, "of the pipe", required},
                     {"density", NumberRule{Range::left_open(0, 7)},
                      "rho of a periodic pipe, particles per site"},
                     {"injection", NumberRule{fraction()}, "I of an open pipe"},
                     {"dissipation", NumberRule{fraction()}, "p", required},
                     {"gravity", NumberRule{fraction()}, "g", required},
                     {"roughness", NumberRule{fraction()}, "b of the walls", required},
                     {"engine", ChoiceRule{all_words<GasEngine>()},
                      "default \"bit-sliced\"; the same bits"},
                     {"word_bits", toml_input::IntegerRule{1, 512},
                      "of the bit-sliced engine; left out: the best for the replicas"},
                     {"on_saturation", ChoiceRule{all_words<OnSaturation>()},
                      "when rest particles exceed the free sites; default \"fail\""}},
            .groups = {toml_input::OneOf{{"density", "injection"}}}};
        for (auto& key : gas_sampling_keys())
            scene.keys.push_back(std::move(key));
        return scene;
    }();
    return keys;
}

LatticeGas read_lattice_gas(const toml_input::TomlTable& table, const SceneSelection& selection) {
    const KeyedTable t(table, lattice_gas_keys());
    LatticeGas gas;
    gas.name = selection.name;
    gas.seed = selection.seed;
    gas.reading = load_gas_reading(reading_file(t, selection.readings));
    gas.sampling = read_gas_sampling(t);
    gas.ends = t.choice<PipeEnds>("ends");
    gas.sampling.periodic = gas.ends == PipeEnds::periodic;
    read_filling(t, gas);
    gas.dissipation = t.number("dissipation");
    gas.gravity = t.number("gravity");
    gas.roughness = t.number("roughness");
    if (t.has("engine")) gas.engine = t.choice<GasEngine>("engine");
    if (t.has("word_bits")) gas.word_bits = static_cast<int>(t.integer("word_bits"));
    if (t.has("on_saturation")) {
        gas.on_saturation = t.choice<OnSaturation>("on_saturation");
    }
    t.reject_unknown_keys();
    check_memory(t, gas);
    return gas;
}

}  // namespace crossgrain::scene
