// The recipes of initial states that have a file of their own. Each fills scene.initial (and
// sizes); what all states must fulfil is checked by generate_initial_state.
#pragma once

#include "cases/scene/initial_state.hpp"

namespace crossgrain::scene {

// All throw std::invalid_argument with a one-line reason if the grains do not fit.
void generate(Scene& scene, const Pairs& pairs, const SizeSpread& sizes);
void generate(Scene& scene, const Pipe& pipe, const SizeSpread& sizes);
void generate(Scene& scene, const Hopper& hopper, const SizeSpread& sizes);
void generate(Scene& scene, const Settled& settled, const SizeSpread& sizes);

}  // namespace crossgrain::scene
