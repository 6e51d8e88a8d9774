#include "adapters/native/gas_model.hpp"

#include <fmt/format.h>

#include <vector>

namespace crossgrain::adapters {
namespace {

lga::SiteState site(const scene::SiteState& s) {
    return {.movers = s.movers, .rests = s.rests};
}

std::vector<lga::Rule> rules(const scene::LatticeGas& scene) {
    std::vector<lga::Rule> rules;
    for (const auto& row : scene.reading.rows) {
        rules.push_back({.before = site(row.before),
                         .after = site(row.after),
                         .probability = row.probability.at(scene.dissipation),
                         .matching = row.matching == scene::Matching::exact
                                         ? lga::Matching::exact
                                         : lga::Matching::spectators,
                         .origin = fmt::format("{}:{}", scene.reading.file, row.line)});
    }
    return rules;
}

}  // namespace

lga::Model gas_model(const scene::LatticeGas& scene) {
    const auto& gravity = scene.reading.gravity;
    return {.rules = rules(scene),
            .gravity_rule = {.rest_to_down = gravity.rest_to_down,
                             .up_diagonals = gravity.up_diagonals,
                             .up_to_rest = gravity.up_to_rest,
                             .on_walls = gravity.on_walls},
            .walls = scene.reading.walls == scene::WallPlace::inside ? lga::WallPlace::inside
                                                                     : lga::WallPlace::outside,
            .relocation = scene.reading.relocation == scene::Relocation::origin_first
                              ? lga::Relocation::origin_first
                              : lga::Relocation::random_walk,
            .length = scene.sampling.length,
            .width = scene.sampling.width,
            .periodic = scene.ends == scene::PipeEnds::periodic,
            .density = scene.density,
            .injection = scene.injection,
            .gravity = scene.gravity,
            .roughness = scene.roughness,
            .replicas = scene.sampling.replicas,
            .seed = scene.seed};
}

}  // namespace crossgrain::adapters
